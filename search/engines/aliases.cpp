// The configurations that have names.
#include "search/engines/registry.hpp"

namespace praxis {

namespace {

/// Puts evaluators for `FF` and `LM` into an expression.
std::string with_evaluators(std::string expression, const std::string& cost_type) {
    const auto replace = [&](std::string_view word, const std::string& text) {
        for (std::size_t at = 0; (at = expression.find(word, at)) != std::string::npos; at += text.size())
            expression.replace(at, word.size(), text);
    };
    replace("FF", "ff(cost_type=" + cost_type + ")");
    replace("LM", "landmark_sum(cost_type=" + cost_type + ")");
    return expression;
}

/// LAMA's queues without that of landmarks alone, and one of states with new pairs of facts (NOLAN; Correa
/// and Seipp 2025).
std::string focused_greedy() {
    return with_evaluators(
        "lazy(alt([single(FF),single(FF,pref_only=true),single(LM,pref_only=true),"
        "tiebreaking([novelty([LM,FF],sample=5000),LM,g()])],boost=1000),preferred=[FF,LM],cost_type=one)",
        "one");
}

/// LAMA's queues, one of states with new pairs of facts, which forgets what it has seen on progress, and one
/// of random types of states (Maidu's h_new; Correa et al., IPC 2023).
std::string diverse_greedy() {
    return with_evaluators(
        "lazy(alt([single(FF),single(FF,pref_only=true),single(LM),single(LM,pref_only=true),"
        "type_based([FF,g()]),tiebreaking([novelty([FF,LM],forget=true,sample=5000),LM])],boost=1000),"
        "preferred=[FF,LM],cost_type=one)",
        "one");
}

/// Best-first width search, BFWS(f5): states with new pairs of facts first, then few open goals (Lipovetzky
/// and Geffner 2017).
std::string width_search() {
    return "eager(tiebreaking([novelty([goalcount(),relaxed_counter()],sample=5000),goalcount()]))";
}

std::string lama_first(const std::string& options = "") {
    return with_evaluators("lazy_greedy([FF,LM],preferred=[FF,LM],cost_type=one" + options + ")", "one");
}

/// A focused search, a diverse one on the pruned task, one that hardly looks at heuristics, and one with
/// other luck.
std::string first_plan() {
    return "portfolio([" + focused_greedy() + ",h2(" + diverse_greedy() + ",seconds=1)," + width_search() +
           "," + lama_first(",randomize_successors=true") + "],first=true,turn=0.5)";
}

/// What LAMA does after its first plan (Richter and Westphal 2010).
std::string lama_rest(const std::string& last_options = "") {
    std::string rest = "lazy_greedy([FF,LM],preferred=[FF,LM])";
    for (const char* weight : {"5", "3", "2"})
        rest += std::string(",lazy_wastar([FF,LM],preferred=[FF,LM],w=") + weight + ")";
    rest += ",lazy_wastar([FF,LM],preferred=[FF,LM],w=1" + last_options + ")";
    return with_evaluators(rest, "plusone");
}

}  // namespace

std::vector<AliasDescription> list_aliases() {
    return {
        {"agile", first_plan(),
         "the first plan, as fast as possible: four searches take turns, or run at once on as many threads: "
         "landmarks, FF and novelty; more diversity on a task pruned by mutexes of pairs; width search; LAMA "
         "with luck of its own"},
        {"anytime",
         "iterated([" + first_plan() + ",portfolio([polish(),iterated([" + lama_rest(",go_on=true") +
             "])])])",
         "the first plan soon, then better and better ones until the time is up: LAMA's searches and the "
         "improvement of the best plan take turns, or run at once on two threads"},
        {"lama-first", lama_first(), "LAMA's first search, for comparison"},
        {"lama", "iterated([" + lama_first() + "," + lama_rest() + "],share=false,improve=false)",
         "LAMA's sequence of searches, for comparison"},
        {"optimal", "astar(lmcut())", "a cheapest plan"}};
}

}  // namespace praxis
