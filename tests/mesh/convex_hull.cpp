#include <scree/mesh/convex_hull.hpp>

#include <chrono>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <catch2/catch.hpp>

#include <scree/mesh/mass_properties.hpp>

#include <tests/support/random.hpp>
#include <tests/support/shapes.hpp>

using namespace scree;
using Catch::Matchers::Contains;

namespace {

using Points = std::vector<Vec3>;

/// What holds of every hull: planar faces, and no vertex above any, to 10⁻¹² of the size; no point left
/// outside by more than merging allows (a vertex may move by 10⁻⁶, and a point dropped within it of another).
ConvexPolyhedron checked_hull(const Points& points) {
    const double size = test::size_of(points);
    const ConvexHull hull = convex_hull(points);
    INFO(hull.solid.vertices.size() << " vertices, " << hull.solid.face_count() << " faces");
    CHECK(test::height_above(hull.solid, hull.solid.vertices) <= 1e-12 * size);
    CHECK(test::unevenness(hull.solid) <= 1e-12 * size);
    CHECK(test::height_above(hull.solid, points) <= 2e-6 * size);
    CHECK(hull.largest_move <= 1e-6 * size);
    return hull.solid;
}

/// The points 0, 1/n … 1 on the faces of the unit cube.
Points cube_grid(int n) {
    Points points;
    for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n; ++j) {
            for (int k = 0; k <= n; ++k) {
                if (i % n == 0 || j % n == 0 || k % n == 0) {
                    points.emplace_back(Vec3(i, j, k) / n);
                }
            }
        }
    }
    return points;
}

/// A cube with a step of the given depth at each corner and edge.
Points bevelled_cube(double depth) {
    Points points;
    for (const Vec3& corner : test::cube_corners()) {
        for (int axis = 0; axis < 3; ++axis) {
            Vec3 p = corner * (1 - 2 * depth);
            p(axis) = corner(axis);
            points.push_back(p);
        }
    }
    return points;
}

}  // namespace

TEST_CASE("Coordinates that merge as they are keep every digit", "[mesh]") {
    const ConvexHull cube = convex_hull(cube_grid(4));
    CHECK(cube.solid.vertices.size() == 8);
    CHECK(cube.solid.face_count() == 6);
    CHECK(cube.largest_move == 0);
    for (const Vec3& v : cube.solid.vertices) {
        CHECK((v.array() == 0 || v.array() == 1).all());
    }
    CHECK(mass_properties(cube.solid).volume == 1);
}

TEST_CASE("Polyhedra turned in a single-precision file come out with their own faces, at any size",
          "[mesh]") {
    test::Random random(1);
    for (const double scale : {1e-6, 1e-3, 0.1, 1.0, 1e3}) {
        for (int i = 0; i < 10; ++i) {
            const auto in_file = [&](const Points& points) {
                return test::as_float(test::turned(points, random.rotation(), scale));
            };
            CHECK(checked_hull(in_file(test::cube_corners())).face_count() == 6);
            CHECK(checked_hull(in_file(cube_grid(7))).face_count() == 6);
            CHECK(checked_hull(in_file(test::prism_corners(6))).face_count() == 8);
            CHECK(checked_hull(in_file(test::rhombic_dodecahedron_corners())).face_count() == 12);
            const MassProperties mass = mass_properties(checked_hull(in_file(test::cube_corners())));
            CHECK(mass.volume == Approx(std::pow(scale, 3)).epsilon(1e-6));
        }
    }
}

TEST_CASE("A vertex is moved onto its planes, and by how much is told", "[mesh]") {
    test::Random random(2);
    const Points cube = test::as_float(test::turned(test::cube_corners(), random.rotation()));
    const ConvexHull hull = convex_hull(cube);
    CHECK(hull.largest_move > 1e-10);
    double largest = 0;
    for (const Vec3& v : hull.solid.vertices) {
        double nearest = 1;
        for (const Vec3& p : cube) {
            nearest = std::min(nearest, (p - v).norm());
        }
        largest = std::max(largest, nearest);
    }
    CHECK(hull.largest_move == Approx(largest).epsilon(1e-6));
}

TEST_CASE("All of 5000 points on a sphere are vertices, in less than a second", "[mesh]") {
    for (const double scale : {1e-6, 1.0, 1e3}) {
        const Points points =
            test::as_float(test::turned(test::spiral_sphere(5000), Quat::Identity(), scale));
        const auto start = std::chrono::steady_clock::now();
        const ConvexHull hull = convex_hull(points);
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        CHECK(hull.solid.vertices.size() == 5000);
#ifdef NDEBUG
        CHECK(time.count() < 1);
#endif
        CHECK(test::height_above(hull.solid, hull.solid.vertices) <= 1e-12 * scale);
    }
}

TEST_CASE("Faces that lean by more than the tolerance stay apart", "[mesh]") {
    test::Random random(3);
    for (const double rise : {1e-1, 1e-3, 1e-5}) {
        Points roof = test::cube_corners();
        roof.emplace_back(0.5 + rise, 0.5, 0);
        roof.emplace_back(0.5 + rise, -0.5, 0);
        CHECK(checked_hull(test::turned(roof, random.rotation())).face_count() == 7);
        CHECK(checked_hull(test::as_float(test::turned(roof, random.rotation()))).face_count() == 7);
    }
    CHECK(checked_hull(bevelled_cube(1e-4)).face_count() == 26);
    CHECK(checked_hull(bevelled_cube(1e-8)).face_count() == 6);
}

TEST_CASE("Hulls hold what they promise on points close to every degenerate case", "[mesh]") {
    test::Random random(4);
    for (int i = 0; i < 300; ++i) {
        const double noise = std::pow(10, random.uniform(-17, -3));
        Points points = i % 2 == 0 ? test::cube_corners() : test::rhombic_dodecahedron_corners();
        if (i % 3 == 0) {
            points = bevelled_cube(std::pow(10, random.uniform(-8, -1)));
        }
        for (int k = 0; k < i % 40; ++k) {
            Vec3 p = random.vector(-0.5, 0.5);
            p(k % 3) = k % 2 == 0 ? 0.5 : -0.5;
            points.push_back(p);
        }
        for (Vec3& p : points) {
            p += noise * random.vector();
        }
        checked_hull(test::turned(points, random.rotation()));
        checked_hull(test::as_float(test::turned(points, random.rotation())));
    }
}

TEST_CASE("Clusters of nearly equal points count as one", "[mesh]") {
    test::Random random(5);
    for (int i = 0; i < 200; ++i) {
        Points points;
        for (int k = 0; k < 4 + i % 20; ++k) {
            const Vec3 middle = random.vector();
            const double noise = std::pow(10, random.uniform(-16, -1));
            for (int copies = 0; copies <= k % 5; ++copies) {
                points.emplace_back(middle + noise * random.vector());
            }
        }
        checked_hull(points);
    }
}

TEST_CASE("Points without a hull are refused with the reason", "[mesh]") {
    const auto refused = [](Points points, const std::string& why) {
        CHECK_THROWS_WITH(convex_hull(points), Contains(why));
        CHECK_THROWS_AS(convex_hull(points), std::invalid_argument);
    };
    const Points cube = test::cube_corners();
    const auto with = [&](const Vec3& extra) {
        Points points = cube;
        points.push_back(extra);
        return points;
    };
    const double infinity = std::numeric_limits<double>::infinity();
    refused({}, "at least four points, found 0");
    refused({cube[0], cube[1], cube[2]}, "at least four points, found 3");
    refused(with({0, infinity, 0}), "point 8 is not finite");
    refused(with({0, 0, std::nan("")}), "point 8 is not finite");
    refused(with({1e30, 0, 0}), "expected at most 1e+09 m");
    refused(Points(8, Vec3(1, 2, 3)), "all 8 points are the same");
    refused(test::turned(cube, Quat::Identity(), 1e-12), "expected at least 1e-09 m");
    Points line;
    Points plane;
    test::Random random(6);
    for (int i = 0; i < 10; ++i) {
        line.emplace_back(random.uniform() * Vec3(1, 2, 3));
        plane.emplace_back(random.uniform() * Vec3(1, 2, 3) + random.uniform() * Vec3(0, 1, 1));
    }
    refused(line, "lie on one line");
    refused(plane, "lie in one plane");
}
