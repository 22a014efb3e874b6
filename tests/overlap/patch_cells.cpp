#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>
#include <scree/overlap/patch_cells.hpp>

#include <tests/support/overlaps.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

namespace {

struct Cut {
    ContactGeometry geometry;
    PatchCells cells;
    bool done = false;
};

Cut cut(const Placed& a, const Placed& b, const Vec3& towards = Vec3::UnitX()) {
    Cut cut;
    OverlapWorkspace workspace;
    if (overlap(a.shape, a.pose, b.shape, b.pose, Detail::derivative, false, workspace, cut.geometry)) {
        const Vec3& n = cut.geometry.normal;
        cut.cells.axis = (towards - towards.dot(n) * n).normalized();
        cut.done = cut_into_cells(cut.geometry, a.pose, workspace, cut.cells);
    }
    return cut;
}

double spin_lever(const PatchCells& cells) {
    double sum = 0;
    for (std::size_t i = 0; i < PatchCells::count; ++i) {
        sum += cells.share[i] * std::hypot(cells.at[i].norm(), cells.lever[i]);
    }
    return sum;
}

Vec2 first_moment(const PatchCells& cells) {
    Vec2 sum = Vec2::Zero();
    for (std::size_t i = 0; i < PatchCells::count; ++i) {
        sum += cells.share[i] * cells.at[i];
    }
    return sum;
}

Eigen::Matrix2d second_moment(const PatchCells& cells) {
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (std::size_t i = 0; i < PatchCells::count; ++i) {
        sum += cells.share[i] * cells.at[i] * cells.at[i].transpose();
    }
    return sum;
}

// ∫ ‖x‖ h dA / ∫ h dA on a grid, of a rectangle about the origin with a depth that falls off along x.
double lever_of_wedge(double length, double width, double slope) {
    constexpr int grid = 600;
    const double centre = slope * length * length / 12;  // of the load: depth 1 + slope x
    double load = 0;
    double moment = 0;
    for (int i = 0; i < grid; ++i) {
        for (int j = 0; j < grid; ++j) {
            const double x = length * ((i + 0.5) / grid - 0.5);
            const double y = width * ((j + 0.5) / grid - 0.5);
            load += 1 + slope * x;
            moment += (1 + slope * x) * std::hypot(x - centre, y);
        }
    }
    return moment / load;
}

}  // namespace

TEST_CASE("The cells of a flat face have its shares and moments", "[overlap]") {
    const Placed box = placed(make_box({0.2, 0.1, 0.05}), {0, 0, 0.0249});
    const Cut flat = cut(box, ground());
    REQUIRE(flat.done);
    double load = 0;
    for (const double share : flat.cells.share) {
        CHECK(share > 0);
        load += share;
    }
    CHECK(load == Approx(1).epsilon(1e-12));
    CHECK(first_moment(flat.cells).norm() < 1e-12);
    CHECK(spin_lever(flat.cells) == Approx(flat.geometry.lever).epsilon(1e-9));
    const Eigen::Matrix2d spread = second_moment(flat.cells);
    CHECK(spread(0, 0) == Approx(0.04 / 12).epsilon(0.04));
    CHECK(spread(1, 1) == Approx(0.01 / 12).epsilon(0.04));
    CHECK(std::abs(spread(0, 1)) < 1e-4 * spread(0, 0));
}

TEST_CASE("A disc's cells have its second moment of area, R²/4, and its lever, 2R/3", "[overlap]") {
    const Cut disc = cut(placed(regular_prism(200, 0.1, 0.05), {0, 0, 0.0249}), ground());
    REQUIRE(disc.done);
    CHECK(spin_lever(disc.cells) == Approx(0.2 / 3).epsilon(1e-3));
    // The spread within the cells is missing.
    CHECK(second_moment(disc.cells)(0, 0) == Approx(0.0025).epsilon(0.03));
    CHECK(second_moment(disc.cells)(1, 1) == Approx(0.0025).epsilon(0.03));
}

TEST_CASE("On a tilted face the deeper side bears the more, and the moment of a spin is the loaded one",
          "[overlap]") {
    // Depth 1 + slope x in units of the mean one.
    const double tilt = 1e-3;
    const double depth = 2e-4;
    const Quat turn = rotation(Vec3(0, tilt, 0));
    const Cut tilted =
        cut(placed(make_box({0.2, 0.1, 0.05}), turn * Vec3(0, 0, 0.025) - Vec3(0, 0, depth), turn), ground());
    REQUIRE(tilted.done);
    CHECK(first_moment(tilted.cells).norm() < 1e-12);
    CHECK(spin_lever(tilted.cells) == Approx(lever_of_wedge(0.2, 0.1, tilt / depth)).epsilon(1e-4));
    double deep = 0;
    for (std::size_t i = 0; i < PatchCells::count; ++i) {
        deep += tilted.cells.at[i].x() + tilted.geometry.centroid.x() > 0 ? tilted.cells.share[i] : 0;
    }
    CHECK(deep == Approx(0.5 + 0.125).epsilon(0.03));  // ½ + slope length/8 of the load
}

TEST_CASE("Cells of random overlaps have the moments that they promise", "[overlap]") {
    Random random(401);
    int done = 0;
    for (int i = 0; i < 300; ++i) {
        const Placed a = placed(random.polyhedron(12, 0.1), Vec3::Zero());
        const Placed b = placed(random.polyhedron(12, 0.1), random.uniform(0.1, 0.19) * random.direction(),
                                random.rotation());
        const Cut one = cut(a, b, random.direction());
        if (!one.done) {
            continue;
        }
        ++done;
        CHECK(first_moment(one.cells).norm() < 1e-12);
        CHECK(spin_lever(one.cells) > 0);
        for (std::size_t k = 0; k < PatchCells::count; ++k) {
            CHECK(one.cells.share[k] >= 0);
            CHECK(one.cells.at[k].norm() < 0.2);
        }
    }
    CHECK(done > 50);
}

TEST_CASE("The cells of a pair are the same seen from either body", "[overlap]") {
    const Placed a =
        placed(make_box({0.2, 0.1, 0.05}), {0.03, 0.01, 0.0249}, rotation(Vec3(0.01, 0.002, 0.5)));
    const Placed b = placed(make_box({0.1, 0.3, 0.05}), {0, 0, -0.025});
    const Cut one = cut(a, b);
    const Cut other = cut(b, a);
    REQUIRE(one.done);
    REQUIRE(other.done);
    CHECK(spin_lever(one.cells) == Approx(spin_lever(other.cells)).epsilon(1e-9));
    const Eigen::Matrix2d spread = second_moment(one.cells);
    const Eigen::Matrix2d mirrored = second_moment(other.cells);
    CHECK(spread(0, 0) == Approx(mirrored(0, 0)).epsilon(1e-9));
    CHECK(spread(0, 1) == Approx(-mirrored(0, 1)).epsilon(1e-6));
}

TEST_CASE("There are no cells where there is no solid to cut", "[overlap]") {
    CHECK_FALSE(cut(placed(Sphere{0.1}, {0, 0, 0.099}), ground()).done);
    CHECK_FALSE(cut(placed(cube(0.1), Vec3::Zero()), placed(cube(0.3), Vec3::Zero())).done);
}
