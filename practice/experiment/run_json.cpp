#include "practice/experiment/run_json.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "parser/diagnostic.hpp"
#include "parser/files.hpp"
#include "practice/experiment/curves.hpp"

namespace praxis::practice {
namespace {

using Json = nlohmann::json;

constexpr const char* kFormat = "praxis-practice-run";
constexpr int kVersion = 1;
constexpr std::size_t kCurveFields = 3;
constexpr std::size_t kCandidateFields = 7;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A value of a file, and where it stands: "choices[3].candidates[0]".
class Reader {
  public:
    Reader(const Source& source, const Json& value, std::string where)
        : source_(source), value_(value), where_(std::move(where)) {}

    [[noreturn]] void refuse(const std::string& wanted) const {
        fail_unplaced(source_.name + ": " + (where_.empty() ? "the file" : where_) + " must be " + wanted +
                      "; remove the file to run it again");
    }
    Reader member(const char* name) const {
        if (!value_.is_object()) refuse("an object");
        const auto found = value_.find(name);
        const std::string where = where_.empty() ? name : where_ + "." + name;
        if (found == value_.end())
            fail_unplaced(source_.name + ": " + where + " is missing; remove the file to run it again");
        return {source_, *found, where};
    }
    std::size_t size() const {
        if (!value_.is_array()) refuse("a list");
        return value_.size();
    }
    void require_size(std::size_t wanted) const {
        if (size() != wanted) refuse("a list of " + std::to_string(wanted));
    }
    Reader operator[](std::size_t i) const {
        return {source_, value_[i], where_ + "[" + std::to_string(i) + "]"};
    }
    std::string text() const {
        if (!value_.is_string()) refuse("a text");
        return value_.get<std::string>();
    }
    std::uint64_t seed() const {
        if (!value_.is_number_unsigned()) refuse("a whole number from 0 to 2^64 - 1");
        return value_.get<std::uint64_t>();
    }
    template <class Integer>
    Integer count(Integer largest = std::numeric_limits<Integer>::max()) const {
        if (!value_.is_number_unsigned() || value_.get<std::uint64_t>() > static_cast<std::uint64_t>(largest))
            refuse("a whole number from 0 to " + std::to_string(largest));
        return value_.get<Integer>();
    }
    double finite() const {
        if (!value_.is_number()) refuse("a number");
        return value_.get<double>();
    }
    double number() const {
        if (value_ == "inf") return kInfinity;
        if (value_ == "-inf") return -kInfinity;
        if (!value_.is_number()) refuse("a number, \"inf\" or \"-inf\"");
        return value_.get<double>();
    }

  private:
    const Source& source_;
    const Json& value_;
    std::string where_;
};

Json number(double value) {
    if (std::isfinite(value)) return value;
    return value > 0 ? "inf" : "-inf";
}

void check(const RunResult& run) {
    const std::vector<Curve> curves = curves_of({&run, 1});
    check_curves(curves);
    const auto require = [](bool right, const char* message) {
        if (!right) throw std::invalid_argument(message);
    };
    require(std::isfinite(run.processor_seconds) && std::isfinite(run.evaluation_seconds),
            "the seconds of a run are not finite");
    for (const PracticeChoice& choice : run.choices) {
        require(choice.cycle >= 0 && choice.transitions >= 0, "a choice before the first cycle");
        for (const CandidateScore& candidate : choice.candidates) {
            require(!std::isnan(candidate.score) && !std::isnan(candidate.competence) &&
                        !std::isnan(candidate.predicted) && !std::isnan(candidate.cost),
                    "a candidate's score is not a number");
            require(candidate.successes >= 0 && candidate.successes <= candidate.tries,
                    "a candidate has more successes than tries, or fewer than none");
        }
    }
}

Json curve_json(const std::vector<CurvePoint>& curve) {
    Json result = Json::array();
    for (const CurvePoint& point : curve)
        result.push_back(Json::array({point.cycle, point.transitions, point.solved}));
    return result;
}

Json choices_json(const std::vector<PracticeChoice>& choices, Json& skills) {
    std::map<std::string, std::size_t> places;
    Json result = Json::array();
    for (const PracticeChoice& choice : choices) {
        Json candidates = Json::array();
        for (const CandidateScore& c : choice.candidates) {
            const auto [place, fresh] = places.try_emplace(c.skill, places.size());
            if (fresh) skills.push_back(c.skill);
            candidates.push_back(Json::array({place->second, number(c.score), number(c.competence),
                                              number(c.predicted), number(c.cost), c.tries, c.successes}));
        }
        result.push_back({{"cycle", choice.cycle},
                          {"transitions", choice.transitions},
                          {"chosen", choice.chosen},
                          {"candidates", std::move(candidates)}});
    }
    return result;
}

std::vector<CurvePoint> read_curve(const Reader& list) {
    std::vector<CurvePoint> curve(list.size());
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const Reader point = list[i];
        point.require_size(kCurveFields);
        curve[i] = {point[0].count<int>(), point[1].count<std::int64_t>(), point[2].finite()};
    }
    return curve;
}

CandidateScore read_candidate(const Reader& row, const std::vector<std::string>& skills) {
    row.require_size(kCandidateFields);
    if (skills.empty()) row[0].refuse("a place in \"skills\", which is empty");
    CandidateScore candidate;
    candidate.skill = skills[row[0].count<std::size_t>(skills.size() - 1)];
    candidate.score = row[1].number();
    candidate.competence = row[2].number();
    candidate.predicted = row[3].number();
    candidate.cost = row[4].number();
    candidate.tries = row[5].count<int>();
    candidate.successes = row[6].count<int>(candidate.tries);
    return candidate;
}

std::vector<PracticeChoice> read_choices(const Reader& list, const std::vector<std::string>& skills) {
    std::vector<PracticeChoice> choices(list.size());
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const Reader choice = list[i];
        choices[i].cycle = choice.member("cycle").count<int>();
        choices[i].transitions = choice.member("transitions").count<std::int64_t>();
        choices[i].chosen = choice.member("chosen").text();
        const Reader candidates = choice.member("candidates");
        choices[i].candidates.resize(candidates.size());
        for (std::size_t c = 0; c < choices[i].candidates.size(); ++c)
            choices[i].candidates[c] = read_candidate(candidates[c], skills);
    }
    return choices;
}

Json parse(const Source& source) {
    require_text(source);
    try {
        return Json::parse(source.text);
    } catch (const Json::parse_error& error) {
        Diagnostic diagnostic;
        const std::size_t at = std::min(source.text.size() - 1, error.byte > 0 ? error.byte - 1 : 0);
        diagnostic.where = {0, static_cast<std::uint32_t>(at), 1};
        diagnostic.message = "this is not JSON";
        diagnostic.hint = "remove the file to run it again";
        throw InputError(to_string(diagnostic, {{source}}), {diagnostic});
    } catch (const Json::exception&) {
        fail_unplaced(source.name + ": a number is too large; remove the file to run it again");
    }
}

}  // namespace

std::string run_to_json(const StoredRun& stored) {
    const RunResult& run = stored.run;
    check(run);
    Json skills = Json::array();
    Json choices = choices_json(run.choices, skills);
    const Json file = {{"format", kFormat},
                       {"version", kVersion},
                       {"fingerprint", stored.fingerprint},
                       {"environment", run.environment},
                       {"method", run.method},
                       {"seed", run.seed},
                       {"processor_seconds", run.processor_seconds},
                       {"evaluation_seconds", run.evaluation_seconds},
                       {"curve", curve_json(run.curve)},
                       {"skills", std::move(skills)},
                       {"choices", std::move(choices)}};
    try {
        return file.dump() + "\n";
    } catch (const Json::type_error&) {
        throw std::invalid_argument("a name or the fingerprint of a run is not UTF-8");
    }
}

StoredRun read_run(const Source& source) {
    const Json file = parse(source);
    const Reader top(source, file, "");
    if (top.member("format").text() != kFormat)
        top.member("format").refuse(std::string("\"") + kFormat + "\"");
    if (top.member("version").count<int>() != kVersion)
        top.member("version").refuse(std::to_string(kVersion));
    StoredRun stored;
    stored.fingerprint = top.member("fingerprint").text();
    stored.run.environment = top.member("environment").text();
    stored.run.method = top.member("method").text();
    stored.run.seed = top.member("seed").seed();
    stored.run.processor_seconds = top.member("processor_seconds").finite();
    stored.run.evaluation_seconds = top.member("evaluation_seconds").finite();
    stored.run.curve = read_curve(top.member("curve"));
    const Reader skills = top.member("skills");
    std::vector<std::string> names(skills.size());
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = skills[i].text();
    stored.run.choices = read_choices(top.member("choices"), names);
    try {
        check(stored.run);
    } catch (const std::invalid_argument& error) {
        fail_unplaced(source.name + ": " + error.what() + "; remove the file to run it again");
    }
    return stored;
}

}  // namespace praxis::practice
