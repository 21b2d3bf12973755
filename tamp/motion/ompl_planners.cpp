#include "tamp/motion/ompl_planners.hpp"

#include <ompl/geometric/planners/est/BiEST.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/est/ProjEST.h>
#include <ompl/geometric/planners/fmt/BFMT.h>
#include <ompl/geometric/planners/fmt/FMT.h>
#include <ompl/geometric/planners/informedtrees/ABITstar.h>
#include <ompl/geometric/planners/informedtrees/AITstar.h>
#include <ompl/geometric/planners/informedtrees/BITstar.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/kpiece/KPIECE1.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/pdst/PDST.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/LazyPRMstar.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/prm/PRMstar.h>
#include <ompl/geometric/planners/prm/SPARS.h>
#include <ompl/geometric/planners/prm/SPARStwo.h>
#include <ompl/geometric/planners/rlrt/BiRLRT.h>
#include <ompl/geometric/planners/rlrt/RLRT.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/InformedRRTstar.h>
#include <ompl/geometric/planners/rrt/LazyRRT.h>
#include <ompl/geometric/planners/rrt/RRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/rrt/RRTXstatic.h>
#include <ompl/geometric/planners/rrt/RRTsharp.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/geometric/planners/rrt/SORRTstar.h>
#include <ompl/geometric/planners/rrt/TRRT.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/geometric/planners/stride/STRIDE.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <string>
#include <vector>

#include "parser/suggest.hpp"
#include "tamp/motion/ompl_planner.hpp"

namespace praxis::tamp {

namespace {

namespace og = ompl::geometric;

using Maker = ompl::base::PlannerPtr (*)(const ompl::base::SpaceInformationPtr&);

template <class Planner>
ompl::base::PlannerPtr make(const ompl::base::SpaceInformationPtr& information) {
    return std::make_shared<Planner>(information);
}

struct Entry {
    std::string_view name;
    Maker maker;
};

/// Sorted by name.
constexpr std::array kPlanners = {
    Entry{"ABITstar", make<og::ABITstar>},
    Entry{"AITstar", make<og::AITstar>},
    Entry{"BFMT", make<og::BFMT>},
    Entry{"BITstar", make<og::BITstar>},
    Entry{"BKPIECE1", make<og::BKPIECE1>},
    Entry{"BiEST", make<og::BiEST>},
    Entry{"BiRLRT", make<og::BiRLRT>},
    Entry{"BiTRRT", make<og::BiTRRT>},
    Entry{"EST", make<og::EST>},
    Entry{"FMT", make<og::FMT>},
    Entry{"InformedRRTstar", make<og::InformedRRTstar>},
    Entry{"KPIECE1", make<og::KPIECE1>},
    Entry{"LBKPIECE1", make<og::LBKPIECE1>},
    Entry{"LazyPRM", make<og::LazyPRM>},
    Entry{"LazyPRMstar", make<og::LazyPRMstar>},
    Entry{"LazyRRT", make<og::LazyRRT>},
    Entry{"PDST", make<og::PDST>},
    Entry{"PRM", make<og::PRM>},
    Entry{"PRMstar", make<og::PRMstar>},
    Entry{"ProjEST", make<og::ProjEST>},
    Entry{"RLRT", make<og::RLRT>},
    Entry{"RRT", make<og::RRT>},
    Entry{"RRTConnect", make<og::RRTConnect>},
    Entry{"RRTXstatic", make<og::RRTXstatic>},
    Entry{"RRTsharp", make<og::RRTsharp>},
    Entry{"RRTstar", make<og::RRTstar>},
    Entry{"SBL", make<og::SBL>},
    Entry{"SORRTstar", make<og::SORRTstar>},
    Entry{"SPARS", make<og::SPARS>},
    Entry{"SPARStwo", make<og::SPARStwo>},
    Entry{"STRIDE", make<og::STRIDE>},
    Entry{"TRRT", make<og::TRRT>},
};

std::string folded(std::string_view word) {
    std::string result(word);
    for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

[[noreturn]] void fail_unknown(std::string_view name) {
    Suggestion suggestion(folded(name));
    for (const Entry& entry : kPlanners) suggestion.consider(folded(entry.name));
    std::string message = "OMPL: no planner " + quote(name);
    for (const Entry& entry : kPlanners) {
        if (suggestion.found() && folded(entry.name) == suggestion.best()) {
            message += "; did you mean " + quote(entry.name) + "?";
        }
    }
    throw std::invalid_argument(message);
}

const Entry& find(std::string_view name) {
    const auto found = std::ranges::find(kPlanners, name, &Entry::name);
    if (found == kPlanners.end()) fail_unknown(name);
    return *found;
}

}  // namespace

const std::vector<std::string>& ompl_planner_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> result;
        for (const Entry& entry : kPlanners) result.emplace_back(entry.name);
        return result;
    }();
    return names;
}

void check_ompl_planner_name(std::string_view name) {
    find(name);
}

ompl::base::PlannerPtr make_ompl_planner(std::string_view name,
                                         const ompl::base::SpaceInformationPtr& information, double range) {
    ompl::base::PlannerPtr planner = find(name).maker(information);
    if (range > 0 && planner->params().hasParam("range")) {
        planner->params().setParam("range", std::to_string(range));
    }
    return planner;
}

}  // namespace praxis::tamp
