#include "fill.hpp"

#include <random>

#include "free_space.hpp"

namespace scree {

namespace {

constexpr int most_attempts = 5000;  // a body

/// Seeded draws, the same on every machine, which the standard's distributions are not.
class Draws {
  public:
    // The entry's number makes two entries with one seed differ; else the second would try the places that
    // the first has taken.
    Draws(std::uint64_t seed, std::size_t entry) : engine_(seed + 0x9e3779b97f4a7c15 * entry) {}

    /// In [low, high).
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }

    Vec3 point(const Vec3& low, const Vec3& high) {
        const double x = uniform(low.x(), high.x());
        const double y = uniform(low.y(), high.y());
        return {x, y, uniform(low.z(), high.z())};
    }

    /// Uniform over all: the direction of a uniform point in the four-dimensional ball.
    Quat orientation() {
        while (true) {
            const double w = uniform(-1, 1);
            const Vec3 v = point(Vec3::Constant(-1), Vec3::Ones());
            const double square = w * w + v.squaredNorm();
            if (square <= 1 && square > 1e-6) {
                return Quat(w, v.x(), v.y(), v.z()).normalized();
            }
        }
    }

  private:
    std::mt19937_64 engine_;
};

/// Finds room for one solid, wholly inside the box. False after too many attempts.
bool find_room(const Shape& shape, const FillDescription& fill, FreeSpace& space, Draws& draws, Pose& pose) {
    for (int attempt = 0; attempt < most_attempts; ++attempt) {
        pose.orientation = draws.orientation();
        const Bounds box = bounds(shape, {Vec3::Zero(), pose.orientation});
        const Vec3 low = fill.low - box.low;
        const Vec3 high = fill.high - box.high;
        if ((low.array() > high.array()).any()) {
            continue;
        }
        pose.position = draws.point(low, high);
        if (space.has_room(shape, pose)) {
            return true;
        }
    }
    return false;
}

/// The size of most of the bodies to be placed.
double cell_size(const SceneDescription& scene, const std::map<std::string, Solid>& solids) {
    double largest = 0;
    for (const FillDescription& fill : scene.fill) {
        largest = std::max(largest, fill.size[1] * bounding_radius(*solids.at(fill.shape).shape));
    }
    return 2 * largest;
}

}  // namespace

void fill_boxes(const SceneDescription& scene, const std::map<std::string, Solid>& solids,
                std::vector<SimulationBody>& bodies, std::size_t first) {
    FreeSpace space(cell_size(scene, solids));
    for (std::size_t i = 0; i < first; ++i) {
        const Solid& solid = bodies[i].solid;
        const Pose body = bodies[i].start.pose * solid.body_in_file;
        for_each_part(solid, [&](const Shape& shape, const Vec3& position) {
            space.add(shape, {body * position, body.orientation});
        });
    }
    std::size_t next = first;
    for (std::size_t i = 0; i < scene.fill.size(); ++i) {
        const FillDescription& fill = scene.fill[i];
        const bool one_size = fill.size[0] == fill.size[1];
        const Solid& shape = solids.at(fill.shape);
        const Solid solid = one_size ? scaled(shape, fill.size[0]) : shape;
        Draws draws(fill.seed, i);
        for (std::size_t k = 0; k < fill.count; ++k) {
            SimulationBody& body = bodies[next++];
            body.material = fill.material;
            body.shape = fill.shape;
            body.size = one_size ? fill.size[0] : draws.uniform(fill.size[0], fill.size[1]);
            body.solid = one_size ? solid : scaled(solid, body.size);
            Pose pose;
            if (!find_room(*body.solid.shape, fill, space, draws, pose)) {
                throw SceneError("fill." + std::to_string(i),
                                 "room for " + std::to_string(k) + " of " + std::to_string(fill.count),
                                 "a larger box, smaller bodies or fewer of them");
            }
            space.add(*body.solid.shape, pose);
            body.start.pose = pose * body.solid.body_in_file.inverse();
        }
    }
}

}  // namespace scree
