// A block let go on a slope: at which angle does it begin to slide? Coulomb says atan μ, whatever the block,
// its size, its stiffness and the direction. One line a case, measured by bisection against that answer.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <numbers>
#include <random>

#include <scree/scenes/incline.hpp>

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double tolerance = 1e-4 * degree;

// Case `number`: meshes, grounds and turned parts in turn, friction, stiffness and directions at random.
scree::Incline incline(int number, std::mt19937& random) {
    const char* const meshes[] = {"cube", "hexagonal_prism", "flat_stone", "stone_a"};
    const auto uniform = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
    const std::filesystem::path folder = std::filesystem::path(SCREE_SOURCE_DIR) / "meshes";
    scree::Incline incline;
    incline.mesh = folder / (std::string(meshes[number % 4]) + ".obj");
    if (number % 2 == 1) {
        incline.ground = folder / "slab.obj";
        incline.ground_scale = 4;
    }
    incline.turn_ground = number / 2 % 2 == 1;
    incline.azimuth = number < 4 ? 0 : uniform(0, 2 * std::numbers::pi);
    incline.turn = uniform(0, 2 * std::numbers::pi);
    incline.youngs_modulus = std::pow(10, uniform(8, 12));
    // A block must not tip before it slides.
    incline.friction = uniform(0.1, std::min(1.2, 0.6 * std::tan(scree::tipping_angle(incline))));
    return incline;
}

}  // namespace

int main(int argc, char** argv) try {
    const int cases = argc > 1 ? std::atoi(argv[1]) : 16;
    const unsigned seed = argc > 2 ? static_cast<unsigned>(std::atoi(argv[2])) : 1;
    std::mt19937 random(seed);
    std::printf("Sliding angle of a mesh block, by bisection to %.0e degrees (seed %u)\n\n",
                tolerance / degree, seed);
    std::printf("%-16s %-10s %-8s %9s %6s %8s %11s %11s %9s %7s %6s\n", "mesh", "ground", "turned",
                "downhill", "mu", "Y [Pa]", "atan mu", "measured", "error", "it/step", "ms");
    double worst = 0;
    for (int number = 0; number < cases; ++number) {
        const scree::Incline block = incline(number, random);
        const scree::MeasuredAngle measured = scree::measure_sliding_angle(block, tolerance);
        const double exact = scree::sliding_angle(block);
        const double error = (measured.angle - exact) / degree;
        worst = std::max(worst, std::abs(error));
        std::printf("%-16s %-10s %-8s %8.2f° %6.3f %8.1e %10.5f° %10.5f° %8.0e° %7.2f %6.1f\n",
                    block.mesh.stem().c_str(),
                    block.ground.empty() ? "half-space" : block.ground.stem().c_str(),
                    block.turn_ground ? "ground" : "gravity", block.azimuth / degree, block.friction,
                    block.youngs_modulus, exact / degree, measured.angle / degree, error,
                    static_cast<double>(measured.newton_iterations) / static_cast<double>(measured.steps),
                    1e3 * measured.seconds);
        std::fflush(stdout);
    }
    std::printf("\nworst error %.1e degrees of %d cases\n", worst, cases);
    return worst < 5e-4 ? EXIT_SUCCESS : EXIT_FAILURE;
} catch (const std::exception& error) {
    std::fprintf(stderr, "sliding_angles: %s\n", error.what());
    return 2;
}
