// How friction sets in under a tile that is let go on a slope which holds it, Fig. 5.16 of the source:
// without damping the tangential spring swings, with it its force rises steadily, and the stiffer it is the
// sooner it carries the tile. Writes two tables beside the exact answers, and draws them where gnuplot is
// installed.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <numbers>
#include <string>

#include <demos/table_and_picture.hpp>
#include <scree/scenes/friction_onset.hpp>

namespace {

namespace fs = std::filesystem;

constexpr double dampings[] = {0, 0.5, 2};  // γt

// The force of the spring over the pull against time in periods, as it came out and exact. Returns the
// largest deviation.
double write_onset(const fs::path& file) {
    std::ofstream csv = table(file, "periods,undamped,exact,damped,exact,critical,exact");
    scree::FrictionOnset onset;
    std::array<scree::OnsetRun, 3> runs;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        onset.tangential_damping = dampings[i];
        runs[i] = scree::run_friction_onset(onset, 3, 40);
    }
    double worst = 0;
    for (std::size_t row = 0; row < runs[0].time.size(); ++row) {
        const double time = runs[0].time[row];
        csv << time * scree::onset_frequency(onset) / (2 * std::numbers::pi);
        for (std::size_t i = 0; i < runs.size(); ++i) {
            onset.tangential_damping = dampings[i];
            const double exact = scree::onset_spring(onset, time);
            csv << ',' << runs[i].spring[row] << ',' << exact;
            worst = std::max(worst, std::abs(runs[i].spring[row] - exact));
        }
        csv << "\n";
    }
    return worst;
}

// When the undamped spring first carries the tile, against kt. Returns the largest relative deviation.
double write_delay(const fs::path& file) {
    std::ofstream csv = table(file, "kt,delay,exact");
    double worst = 0;
    for (int tenths = 70; tenths <= 110; tenths += 5) {
        scree::FrictionOnset onset;
        onset.youngs_modulus = std::pow(10, 0.1 * tenths);
        const double frequency = scree::onset_frequency(onset);
        const double delay = scree::onset_delay(scree::run_friction_onset(onset, 1, 400), 1);
        const double exact = std::numbers::pi / (2 * frequency);
        csv << frequency * frequency * scree::onset_mass() << ',' << delay << ',' << exact << "\n";
        worst = std::max(worst, std::abs(delay / exact - 1));
    }
    return worst;
}

}  // namespace

int main(int argc, char** argv) try {
    const fs::path out = argc > 1 ? argv[1] : "out/friction_onset";
    fs::create_directories(out);
    const double onset_error = write_onset(out / "onset.csv");
    const double delay_error = write_delay(out / "delay.csv");
    std::printf(
        "Friction sets in under a tile let go on a slope: within %.1e of the damped oscillator's\n"
        "closed form; carries the tile after (pi/2) sqrt(m/kt), within %.1e of it\n",
        onset_error, delay_error);
    std::printf("tables: %s\n", out.c_str());
    draw("friction_onset", out);
    return onset_error < 0.02 && delay_error < 0.01 ? EXIT_SUCCESS : EXIT_FAILURE;
} catch (const std::exception& error) {
    std::fprintf(stderr, "friction_onset: %s\n", error.what());
    return 2;
}
