#include "tamp/motion/ompl_space.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/ProjectionEvaluator.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "parser/suggest.hpp"

namespace praxis::tamp {

namespace {

namespace ob = ompl::base;

/// The first two of OMPL's numbers: of a base its place, of an arm its shoulder.
class FirstTwo : public ob::ProjectionEvaluator {
  public:
    FirstTwo(const ob::StateSpacePtr& space, unsigned dimension)
        : ob::ProjectionEvaluator(space), dimension_(dimension) {}

    unsigned getDimension() const override { return dimension_; }
    void defaultCellSizes() override {
        bounds_.resize(dimension_);
        inferBounds();
        cellSizes_.resize(dimension_);
        for (unsigned i = 0; i < dimension_; ++i)
            cellSizes_[i] = std::max(kLeastCell, (bounds_.high[i] - bounds_.low[i]) / kCells);
    }
    void project(const ob::State* state, Eigen::Ref<Eigen::VectorXd> projection) const override {
        for (unsigned i = 0; i < dimension_; ++i) {
            projection[i] = *space_->getValueAddressAtIndex(const_cast<ob::State*>(state), i);
        }
    }

  private:
    static constexpr double kCells = 20;
    static constexpr double kLeastCell = 1e-3;
    unsigned dimension_;
};

class CheckerMotions : public ob::MotionValidator {
  public:
    CheckerMotions(const ob::SpaceInformationPtr& information, OmplSpace& space)
        : ob::MotionValidator(information), space_(space) {}

    bool checkMotion(const ob::State* from, const ob::State* to) const override {
        return count(space_.is_motion_free(from, to));
    }
    bool checkMotion(const ob::State* from, const ob::State* to,
                     std::pair<ob::State*, double>& last_valid) const override {
        double share = 0;
        if (count(space_.is_motion_free(from, to, share))) return true;
        last_valid.second = share;
        if (last_valid.first != nullptr) {
            si_->getStateSpace()->interpolate(from, to, share, last_valid.first);
        }
        return false;
    }

  private:
    bool count(bool free) const {
        ++(free ? valid_ : invalid_);
        return free;
    }
    OmplSpace& space_;
};

}  // namespace

OmplSpace::OmplSpace(CollisionChecker& checker, double step, double turning_weight)
    : checker_(checker), step_(step) {
    const Robot& robot = *checker.problem().robot;
    const Group& group = robot.groups[static_cast<std::size_t>(checker.problem().group)];
    std::vector<std::size_t> circles;
    for (std::size_t j = 0; j < group.variables.size(); ++j) {
        const Variable& variable = robot.variables[static_cast<std::size_t>(group.variables[j])];
        continuous_.push_back(variable.continuous);
        (variable.continuous ? circles : order_).push_back(j);
        if (!variable.continuous && !(std::isfinite(variable.lower) && std::isfinite(variable.upper))) {
            throw std::invalid_argument("OMPL: variable " + quote(variable.name) +
                                        " has no limits: give it a lower and an upper one");
        }
    }
    const auto bounded = static_cast<unsigned>(order_.size());
    auto slides = std::make_shared<ob::RealVectorStateSpace>(bounded);
    ob::RealVectorBounds bounds(bounded);
    for (unsigned i = 0; i < bounded; ++i) {
        const Variable& variable = robot.variables[static_cast<std::size_t>(group.variables[order_[i]])];
        bounds.low[i] = variable.lower;
        bounds.high[i] = variable.upper;
    }
    slides->setBounds(bounds);
    if (circles.empty()) {
        space_ = slides;
    } else {
        auto compound = std::make_shared<ob::CompoundStateSpace>();
        if (bounded > 0) compound->addSubspace(slides, 1);
        for (std::size_t i = 0; i < circles.size(); ++i) {
            compound->addSubspace(std::make_shared<ob::SO2StateSpace>(), turning_weight);
        }
        compound->lock();
        space_ = compound;
        order_.insert(order_.end(), circles.begin(), circles.end());
    }
    for (std::vector<double>* scratch : {&numbers_, &zero_, &from_, &to_, &middle_}) {
        scratch->resize(order_.size());
    }
    information_ = std::make_shared<ob::SpaceInformation>(space_);
    information_->setStateValidityChecker([this](const ob::State* state) { return is_free(state); });
    information_->setMotionValidator(std::make_shared<CheckerMotions>(information_, *this));
    information_->setup();
    // After the setup, which registers a projection of OMPL's own (the identity, for two variables).
    const auto projection =
        std::make_shared<FirstTwo>(space_, std::min(2U, static_cast<unsigned>(order_.size())));
    projection->setup();
    space_->registerDefaultProjection(projection);
}

void OmplSpace::write(std::span<const double> positions, ob::State* state) const {
    for (std::size_t i = 0; i < order_.size(); ++i) numbers_[i] = positions[order_[i]];
    space_->copyFromReals(state, numbers_);
    space_->enforceBounds(state);
}

void OmplSpace::read(const ob::State* state, std::span<const double> near,
                     std::span<double> positions) const {
    space_->copyToReals(numbers_, state);
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const std::size_t column = order_[i];
        positions[column] = continuous_[column] ? near[column] + std::remainder(numbers_[i] - near[column],
                                                                                2 * std::numbers::pi)
                                                : numbers_[i];
    }
}

bool OmplSpace::is_free(const ob::State* state) {
    ++states_;
    read(state, zero_, from_);
    return checker_.is_free(from_);
}

void OmplSpace::read_ends(const ob::State* from, const ob::State* to) {
    ++motions_;
    read(from, zero_, from_);
    read(to, from_, to_);
}

bool OmplSpace::is_motion_free(const ob::State* from, const ob::State* to) {
    read_ends(from, to);
    return checker_.is_motion_free(from_, to_, step_);
}

bool OmplSpace::is_motion_free(const ob::State* from, const ob::State* to, double& free_share) {
    if (is_motion_free(from, to)) return true;
    double squared = 0;
    for (std::size_t j = 0; j < from_.size(); ++j) squared += (to_[j] - from_[j]) * (to_[j] - from_[j]);
    const double least = step_ / std::max(step_, std::sqrt(squared));
    double free = 0;
    for (double blocked = 1; blocked - free > least;) {
        const double share = (free + blocked) / 2;
        for (std::size_t j = 0; j < from_.size(); ++j) middle_[j] = from_[j] + share * (to_[j] - from_[j]);
        (checker_.is_motion_free(from_, middle_, step_) ? free : blocked) = share;
    }
    free_share = free;
    return false;
}

}  // namespace praxis::tamp
