// The error of a run follows the tolerance that was asked for: in the norm that the steps are controlled in,
// against the same scene at a far tighter tolerance, at every output time.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

using namespace scree;

namespace {

struct Problem {
    const char* name;
    const char* scene;
};

const Problem free_top{"free top", R"({
    "gravity": [0, 0, 0],
    "materials": {"rock": {"density": 2600, "youngs_modulus": 1e9, "friction": 0.5}},
    "shapes": {"brick": {"box": [0.1, 0.15, 0.2]}},
    "bodies": [{"shape": "brick", "material": "rock", "angular_velocity": [3, 5, 7]}],
    "end_time": 1, "output": {"every": 0.1}
})"};

// A cube that starts out of balance and tilted, but whose whole face stays in the ground: heave and rock.
const Problem floating{"floating block", R"({
    "materials": {"rubber": {"density": 1000, "youngs_modulus": 1e4, "friction": 0, "normal_damping": 0.1}},
    "shapes": {"floor": {"half_space": {"normal": [0, 0, 1]}}, "cube": {"box": [0.1, 0.1, 0.1]}},
    "bodies": [{"shape": "floor", "material": "rubber", "motion": "fixed"},
               {"shape": "cube", "material": "rubber", "position": [0, 0, 0.04],
                "orientation": [0.9999, 0.01, 0.006, 0]}],
    "end_time": 0.5, "output": {"every": 0.05}
})"};

const Problem bounce{"bounce", R"({
    "materials": {"rock": {"density": 1000, "youngs_modulus": 1e7, "friction": 0.5, "normal_damping": 0.1}},
    "shapes": {"floor": {"half_space": {"normal": [0, 0, 1]}}, "cube": {"box": [0.1, 0.1, 0.1]}},
    "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
               {"shape": "cube", "material": "rock", "position": [0, 0, 0.07]}],
    "end_time": 0.25, "output": {"every": 0.025}
})"};

// Of equal boxes in a row that just touch the first is shot at the others.
const Problem three_boxes{"cradle of three", R"({
    "gravity": [0, 0, 0],
    "materials": {"steel": {"density": 1000, "youngs_modulus": 1e8, "friction": 0, "normal_damping": 0}},
    "shapes": {"cube": {"box": [0.1, 0.1, 0.1]}},
    "bodies": [{"shape": "cube", "material": "steel", "position": [-0.2, 0, 0], "velocity": [1, 0, 0]},
               {"shape": "cube", "material": "steel", "position": [0, 0, 0]},
               {"shape": "cube", "material": "steel", "position": [0.1, 0, 0]}],
    "end_time": 0.2, "output": {"every": 0.02}
})"};

const Problem five_boxes{"cradle of five", R"({
    "gravity": [0, 0, 0],
    "materials": {"steel": {"density": 1000, "youngs_modulus": 1e8, "friction": 0, "normal_damping": 0.2}},
    "shapes": {"cube": {"box": [0.1, 0.1, 0.1]}},
    "bodies": [{"shape": "cube", "material": "steel", "position": [-0.2, 0, 0], "velocity": [1, 0, 0]},
               {"shape": "cube", "material": "steel", "position": [0, 0, 0]},
               {"shape": "cube", "material": "steel", "position": [0.1, 0, 0]},
               {"shape": "cube", "material": "steel", "position": [0.2, 0, 0]},
               {"shape": "cube", "material": "steel", "position": [0.3, 0, 0]}],
    "end_time": 0.2, "output": {"every": 0.02}
})"};

const Problem sliding{"sliding to rest", R"({
    "materials": {"rock": {"density": 2600, "youngs_modulus": 1e8, "friction": 0.5}},
    "shapes": {"floor": {"half_space": {"normal": [0, 0, 1]}}, "tile": {"box": [0.2, 0.2, 0.02]}},
    "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
               {"shape": "tile", "material": "rock", "position": [0, 0, 0.00999936], "velocity": [1, 0.3, 0]}],
    "end_time": 0.3, "output": {"every": 0.03}
})"};

const Problem rolling{"sphere from sliding to rolling", R"({
    "materials": {"rock": {"density": 2600, "youngs_modulus": 1e8, "friction": 0.3}},
    "shapes": {"floor": {"half_space": {"normal": [0, 0, 1]}}, "ball": {"sphere": 0.05}},
    "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
               {"shape": "ball", "material": "rock", "position": [0, 0, 0.0499], "velocity": [1, 0, 0],
                "angular_velocity": [4, 0, 0]}],
    "end_time": 0.4, "output": {"every": 0.04}
})"};

// A table that shakes a little harder than friction can follow: the block sticks, is released, and sticks
// again.
const Problem shaken{"stuck and released", R"({
    "materials": {"rock": {"density": 2600, "youngs_modulus": 1e8, "friction": 0.5}},
    "shapes": {"floor": {"half_space": {"normal": [0, 0, 1]}}, "tile": {"box": [0.2, 0.2, 0.02]}},
    "bodies": [{"shape": "floor", "material": "rock",
                "motion": {"velocity": [1, 0, 0], "amplitude": 0.0075, "frequency": 5}},
               {"shape": "tile", "material": "rock", "position": [0, 0, 0.00999936]}],
    "end_time": 0.4, "output": {"every": 0.04}
})"};

const Problem rocking{"rocking block", R"({
    "materials": {"rock": {"density": 2600, "youngs_modulus": 1e8, "friction": 0.8}},
    "shapes": {"floor": {"half_space": {"normal": [0, 0, 1]}}, "block": {"box": [0.1, 0.1, 0.3]}},
    "bodies": [{"shape": "floor", "material": "rock", "motion": "fixed"},
               {"shape": "block", "material": "rock", "position": [0.004, 0, 0.1537],
                "orientation": [0.99862953, 0, 0.0523359562, 0]}],
    "end_time": 0.4, "output": {"every": 0.04}
})"};

struct Frame {
    FrameMotion motion;
    double radius;  // [m], of the sphere of the body's volume
};

// At every output time, one a dynamic body.
std::vector<std::vector<Frame>> frames_of(const Problem& problem, double rtol) {
    char setting[64];
    std::snprintf(setting, sizeof setting, "stepping.rtol=%g", rtol);
    char floor[64];
    std::snprintf(floor, sizeof floor, "stepping.atol=%g", 1e-3 * rtol);
    Simulation simulation(parse_scene(problem.scene, problem.name, {setting, floor}));
    std::vector<std::vector<Frame>> frames;
    while (simulation.tick() < simulation.times().last()) {
        REQUIRE(simulation.advance());
        frames.emplace_back();
        for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
            const SimulationBody& body = simulation.bodies()[b];
            if (body.dynamic()) {
                frames.back().push_back(
                    {simulation.body_motion(b), std::cbrt(3 * body.solid.volume / (4 * std::numbers::pi))});
            }
        }
    }
    return frames;
}

// Root mean square of a body's errors over their units.
double error_of(const Frame& found, const Frame& expected, double gravity) {
    const double size = expected.radius;
    const double fall = std::sqrt(gravity * size);
    const double speed = std::max(expected.motion.velocity.norm(), fall);
    const double turning = std::max(expected.motion.angular_velocity.norm(), fall / size);
    const double position = (found.motion.pose.position - expected.motion.pose.position).norm() / size;
    const double angle = found.motion.pose.orientation.angularDistance(expected.motion.pose.orientation);
    const double velocity = (found.motion.velocity - expected.motion.velocity).norm() / speed;
    const double spin = (found.motion.angular_velocity - expected.motion.angular_velocity).norm() / turning;
    return std::sqrt((position * position + angle * angle + velocity * velocity + spin * spin) / 4);
}

double largest_error(const std::vector<std::vector<Frame>>& found,
                     const std::vector<std::vector<Frame>>& expected) {
    double largest = 0;
    for (std::size_t t = 0; t < expected.size(); ++t) {
        for (std::size_t b = 0; b < expected[t].size(); ++b) {
            largest = std::max(largest, error_of(found[t][b], expected[t][b], 9.81));
        }
    }
    return largest;
}

std::vector<double> errors_of(const Problem& problem, const std::vector<double>& rtols, double finest) {
    const auto expected = frames_of(problem, finest);
    std::vector<double> errors;
    for (const double rtol : rtols) {
        errors.push_back(largest_error(frames_of(problem, rtol), expected));
    }
    return errors;
}

const std::vector<double> rtols{1e-3, 1e-4, 1e-5, 1e-6};
constexpr double finest = 1e-8;

}  // namespace

TEST_CASE("A smooth motion's error is twenty times the tolerance at most, and falls as it does") {
    for (const Problem& problem : {free_top, floating}) {
        CAPTURE(problem.name);
        const std::vector<double> errors = errors_of(problem, rtols, finest);
        CAPTURE(errors);
        for (std::size_t i = 0; i < rtols.size(); ++i) {
            CHECK(errors[i] < 20 * rtols[i]);
        }
        const double slope =
            std::log(errors.back() / errors.front()) / std::log(rtols.back() / rtols.front());
        CHECK(slope == Approx(1).margin(0.2));
    }
}

TEST_CASE(
    "With contacts that open, close, stick and slip the error is a hundred times the tolerance at most") {
    for (const Problem& problem : {bounce, three_boxes, five_boxes, sliding, rolling, shaken, rocking}) {
        CAPTURE(problem.name);
        const std::vector<double> errors = errors_of(problem, rtols, finest);
        CAPTURE(errors);
        for (std::size_t i = 0; i < rtols.size(); ++i) {
            CHECK(errors[i] < 100 * rtols[i]);
        }
    }
}
