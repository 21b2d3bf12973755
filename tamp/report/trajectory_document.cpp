#include "tamp/report/trajectory_document.hpp"

#include <algorithm>

namespace praxis::tamp {

namespace {

template <class Named>
int find_named(const std::vector<Named>& all, const std::string& name) {
    const auto found = std::ranges::find(all, name, &Named::name);
    return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

}  // namespace

double TrajectoryDocument::duration() const {
    double end = 0;
    for (const Action& action : plan) end = std::max(end, action.end);
    for (const Segment& segment : segments) end = std::max(end, segment.end);
    return end;
}

int TrajectoryDocument::find_link(const std::string& name) const {
    return find_named(robot.links, name);
}

int TrajectoryDocument::find_body(const std::string& name) const {
    return find_named(bodies, name);
}

}  // namespace praxis::tamp
