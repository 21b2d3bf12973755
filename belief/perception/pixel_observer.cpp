#include "belief/perception/pixel_observer.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>

namespace praxis::belief {

std::vector<Spot> find_spots(const Image& image, Colour colour, int tolerance, std::size_t fewest) {
    const auto fits = [&](std::size_t pixel) {
        for (std::size_t i = 0; i < 3; ++i) {
            if (std::abs(int{image.rgb[pixel * 3 + i]} - int{colour[i]}) > tolerance) return false;
        }
        return true;
    };
    std::vector<Spot> spots;
    std::vector<bool> visited(image.width * image.height, false);
    std::vector<std::size_t> stack;
    for (std::size_t first = 0; first < visited.size(); ++first) {
        if (visited[first] || !fits(first)) continue;
        Spot spot;
        visited[first] = true;
        stack.push_back(first);
        while (!stack.empty()) {
            const std::size_t pixel = stack.back();
            stack.pop_back();
            const std::size_t column = pixel % image.width;
            const std::size_t row = pixel / image.width;
            ++spot.pixels;
            spot.pixel[0] += static_cast<double>(column);
            spot.pixel[1] += static_cast<double>(row);
            const auto visit = [&](std::size_t neighbour) {
                if (visited[neighbour] || !fits(neighbour)) return;
                visited[neighbour] = true;
                stack.push_back(neighbour);
            };
            if (column > 0) visit(pixel - 1);
            if (column + 1 < image.width) visit(pixel + 1);
            if (row > 0) visit(pixel - image.width);
            if (row + 1 < image.height) visit(pixel + image.width);
        }
        if (spot.pixels < fewest) continue;
        for (double& middle : spot.pixel) middle /= static_cast<double>(spot.pixels);
        spots.push_back(spot);
    }
    return spots;
}

PixelObserver::PixelObserver(ImageSource& images, const PixelClassifier& classifier,
                             std::vector<SpotType> spots, ObjectMemoryOptions memory)
    : images_(images), classifier_(classifier), spots_(std::move(spots)), memory_(std::move(memory)) {}

Percept PixelObserver::observe(const ObservationRequest& request, std::stop_token stop) {
    const std::vector<View> views = images_.look(stop);
    if (views.empty()) throw PerceptionError("there is no image to look at");
    std::vector<Image> images;
    images.reserve(views.size());
    for (const View& view : views) images.push_back(decode_png(view.image));
    ++step_;
    for (const std::string& object : request.objects) memory_.reserve(object);

    Percept percept;
    const auto judgements = classifier_.judge(colour_grid(images));
    const std::set<AtomName> asked(request.questions.begin(), request.questions.end());
    for (std::size_t i = 0; i < judgements.size(); ++i) {
        const AtomName& atom = classifier_.atoms()[i];
        if (asked.contains(atom)) {
            percept.readings.push_back({atom, judgements[i].value, classifier_.accuracies()[i]});
        }
    }
    for (std::size_t v = 0; v < views.size(); ++v) {
        std::vector<Detection> detections;
        for (const SpotType& type : spots_) {
            if (type.view != views[v].name || !views[v].depth) continue;
            for (const Spot& spot : find_spots(images[v], type.colour, type.tolerance, type.fewest)) {
                const auto position = views[v].depth->lift(spot.pixel[0], spot.pixel[1]);
                if (position) detections.push_back({"", type.type, position, 1});
            }
        }
        const auto associations = memory_.associate(detections, step_);
        for (std::size_t i = 0; i < detections.size(); ++i) {
            if (!associations[i]) continue;
            detections[i].object = memory_.objects()[associations[i]->object].name;
            percept.detections.push_back(detections[i]);
        }
    }
    return percept;
}

}  // namespace praxis::belief
