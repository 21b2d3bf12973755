#include "practice/experiment/curve_files.hpp"

#include <charconv>
#include <map>
#include <tuple>

#include "parser/files.hpp"
#include "practice/experiment/csv.hpp"
#include "practice/experiment/number_text.hpp"

namespace praxis::practice {
namespace {

constexpr const char* kHeader = "environment,method,seed,cycle,transitions,solved";

/// The fields of a row.
struct Field {
    enum : std::size_t { environment, method, seed, cycle, transitions, solved, count };
};

template <class Number>
Number number(const CsvReader& reader, std::size_t field, const char* wanted) {
    const std::string& text = reader.fields()[field];
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        reader.refuse_field(field, "'" + text + "' is not " + wanted, "");
    return value;
}

/// The evaluation in a row; `curve`: the rows of its run so far.
CurvePoint read_point(const CsvReader& reader, const Curve& curve) {
    CurvePoint point;
    point.cycle = number<int>(reader, Field::cycle, "a number of a cycle");
    point.transitions = number<std::int64_t>(reader, Field::transitions, "a number of transitions");
    point.solved = number<double>(reader, Field::solved, "a fraction");
    const CurvePoint least = curve.points.empty() ? CurvePoint{-1, 0, 0} : curve.points.back();
    if (point.cycle <= least.cycle)
        reader.refuse_field(
            Field::cycle, "cycles of a run must rise from 0 on",
            curve.points.empty() ? "" : "the row before it is of cycle " + std::to_string(least.cycle));
    if (point.transitions < least.transitions)
        reader.refuse_field(Field::transitions, "transitions of a run must not fall",
                            "there were " + std::to_string(least.transitions) + " before");
    if (!(point.solved >= 0 && point.solved <= 1))
        reader.refuse_field(Field::solved, "the fraction of solved tasks is from 0 to 1", "");
    return point;
}

}  // namespace

std::string curves_to_csv(std::span<const Curve> curves) {
    check_curves(curves);
    std::string text = std::string(kHeader) + "\n";
    for (const Curve& curve : curves) {
        const std::string run = csv_field(curve.environment) + "," + csv_field(curve.method) + "," +
                                std::to_string(curve.seed) + ",";
        for (const CurvePoint& point : curve.points)
            text += run + std::to_string(point.cycle) + "," + std::to_string(point.transitions) + "," +
                    exact(point.solved) + "\n";
    }
    return text;
}

std::string summaries_to_csv(std::span<const CurveSummary> summaries) {
    std::string text = "environment,method,transitions,mean,low,high,n\n";
    for (const CurveSummary& summary : summaries) {
        const std::string name = csv_field(summary.environment) + "," + csv_field(summary.method) + ",";
        for (const auto& [at, estimate] : summary.points)
            text += name + std::to_string(at) + "," + exact(estimate.value) + "," + exact(estimate.low) +
                    "," + exact(estimate.high) + "," + std::to_string(estimate.count) + "\n";
    }
    return text;
}

std::vector<Curve> read_curves(const Source& source) {
    require_text(source);
    CsvReader reader(source);
    std::vector<Curve> curves;
    std::map<std::tuple<std::string, std::string, std::uint64_t>, std::size_t> places;
    bool in_header = true;
    while (reader.next()) {
        const std::vector<std::string>& fields = reader.fields();
        if (in_header) {
            std::string header;
            for (const std::string& field : fields) header += (header.empty() ? "" : ",") + field;
            if (header != kHeader)
                reader.refuse_row("not a file of learning curves",
                                  std::string("the first line must be ") + kHeader);
            in_header = false;
            continue;
        }
        if (fields.size() != Field::count)
            reader.refuse_row("a row has " + std::to_string(+Field::count) + " fields, this one has " +
                                  std::to_string(fields.size()),
                              "");
        const auto seed = number<std::uint64_t>(reader, Field::seed, "a seed");
        const auto [place, fresh] =
            places.try_emplace({fields[Field::environment], fields[Field::method], seed}, curves.size());
        if (fresh) curves.push_back({fields[Field::environment], fields[Field::method], seed, {}});
        Curve& curve = curves[place->second];
        curve.points.push_back(read_point(reader, curve));
    }
    return curves;
}

}  // namespace praxis::practice
