#include "belief/perception/vision_observer.hpp"

#include <algorithm>
#include <set>

namespace praxis::belief {
namespace {

void check_accuracy(double accuracy) {
    if (!(accuracy > 0.5 && accuracy <= 1)) {
        throw PerceptionError("the accuracy of an answer must be above 0.5 and at most 1, not " +
                              std::to_string(accuracy));
    }
}

std::vector<std::string> names_of(const std::vector<View>& views) {
    std::vector<std::string> names;
    for (const View& view : views) {
        if (std::ranges::find(names, view.name) != names.end()) {
            throw PerceptionError("two views are named '" + view.name + '\'');
        }
        if (view.depth) view.depth->check();
        names.push_back(view.name);
    }
    if (names.empty()) throw PerceptionError("there is no image to look at");
    return names;
}

}  // namespace

VisionObserver::VisionObserver(ChatModel& model, ImageSource& images, VisionObserverOptions options)
    : model_(model), images_(images), options_(std::move(options)), memory_(options_.memory) {
    check_accuracy(options_.accuracy);
    for (const auto& [name, question] : options_.texts.predicates) {
        if (question.accuracy) check_accuracy(*question.accuracy);
    }
    if (options_.attempts < 1) throw PerceptionError("an observer needs at least one attempt");
    if (options_.questions < 1) throw PerceptionError("a prompt needs room for at least one question");
}

void VisionObserver::warn(const std::string& text) const {
    if (options_.warn) options_.warn(text);
}

double VisionObserver::accuracy_of(const AtomName& atom) const {
    const auto found = options_.texts.predicates.find(atom.words.front());
    return found == options_.texts.predicates.end() ? options_.accuracy
                                                    : found->second.accuracy.value_or(options_.accuracy);
}

Percept VisionObserver::observe(const ObservationRequest& request, std::stop_token stop) {
    std::vector<AtomName> questions;
    std::set<AtomName> asked;
    for (const AtomName& atom : request.questions) {
        if (atom.words.empty()) continue;
        const auto found = options_.texts.predicates.find(atom.words.front());
        if (found != options_.texts.predicates.end() && !found->second.ask) continue;
        if (asked.insert(atom).second) questions.push_back(atom);
    }
    Percept percept;
    if (questions.empty() && options_.texts.types.empty()) return percept;

    const std::vector<View> views = images_.look(stop);
    const std::vector<std::string> names = names_of(views);
    ++step_;
    for (const std::string& object : request.objects) memory_.reserve(object);
    for (std::size_t begin = 0; begin == 0 || begin < questions.size(); begin += options_.questions) {
        const auto batch =
            std::span(questions).subspan(begin, std::min(options_.questions, questions.size() - begin));
        const QuestionAnswers answers = ask(views, names, request.objects, batch, stop);
        for (std::size_t i = 0; i < batch.size(); ++i) {
            percept.readings.push_back({batch[i], answers.values[i], accuracy_of(batch[i])});
        }
        if (begin == 0) detect(views, answers.seen, request.objects, percept);
    }
    return percept;
}

QuestionAnswers VisionObserver::ask(const std::vector<View>& views, std::span<const std::string> names,
                                    std::span<const std::string> objects, std::span<const AtomName> questions,
                                    const std::stop_token& stop) {
    std::vector<Message> messages = {
        {Role::system,
         "You look at images of a robot's workplace and report what they show. You answer in JSON only.",
         {}},
        {Role::user, question_prompt(options_.texts, names, objects, questions), {}}};
    for (const View& view : views) messages.back().images.push_back(view.image);

    for (int attempt = 1;; ++attempt) {
        const ChatAnswer answer = model_.ask(messages, stop);
        QuestionAnswers read =
            read_question_answers(answer.text, questions.size(), names, options_.texts.types);
        if (!read.usable && answer.cut_off) read.problems.emplace_back("the answer is cut off");
        for (const std::string& problem : read.problems) warn("the model's answer: " + problem);
        if (read.usable) return read;
        if (attempt >= options_.attempts) {
            warn("the model gave no usable answer in " + std::to_string(attempt) +
                 " attempts: all that was asked stays unknown");
            read.seen.clear();
            return read;
        }
        constexpr std::size_t kRepeated = 4000;  // bytes; a babbling model is not shown all of it again
        messages.push_back({Role::assistant, answer.text.substr(0, kRepeated), {}});
        messages.push_back(
            {Role::user,
             "That answer cannot be used: " + read.problems.front() +
                 ". Answer again, with one JSON object of the form asked for and nothing else.",
             {}});
    }
}

void VisionObserver::detect(const std::vector<View>& views, const std::vector<SeenObject>& seen,
                            std::span<const std::string> objects, Percept& percept) {
    std::vector<std::optional<std::size_t>> told(memory_.objects().size());  // object -> detection
    for (std::size_t view = 0; view < views.size(); ++view) {
        std::vector<Detection> detections;
        for (const SeenObject& thing : seen) {
            if (thing.view != view) continue;
            Detection detection{thing.object, thing.type, std::nullopt, thing.confidence};
            if (thing.pixel && views[view].depth) {
                detection.position = views[view].depth->lift((*thing.pixel)[0], (*thing.pixel)[1]);
            }
            // A name that the model was not given is its own invention, and may be another thing's in the
            // next view.
            const bool known = memory_.find(thing.object) != nullptr ||
                               std::ranges::find(objects, thing.object) != objects.end();
            if (!known && detection.position) detection.object.clear();
            detections.push_back(std::move(detection));
        }
        const auto associations = memory_.associate(detections, step_);
        told.resize(memory_.objects().size());
        for (std::size_t i = 0; i < detections.size(); ++i) {
            if (!associations[i]) {
                warn("a detected " + detections[i].type + " has neither a name nor a position: left out");
                continue;
            }
            const RememberedObject& object = memory_.objects()[associations[i]->object];
            detections[i].object = object.name;
            detections[i].type = object.type;
            auto& place = told[associations[i]->object];
            if (!place) {
                place = percept.detections.size();
                percept.detections.push_back(std::move(detections[i]));
                continue;
            }
            Detection& before = percept.detections[*place];
            if (!before.position) before.position = detections[i].position;
            before.confidence = std::max(before.confidence, detections[i].confidence);
        }
    }
}

}  // namespace praxis::belief
