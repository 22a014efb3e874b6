#include <catch2/catch.hpp>

#include <scree/mesh/convex_hull.hpp>

#include <tests/overlap/independent_volume.hpp>
#include <tests/support/overlaps.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

namespace {

struct Pair {
    ConvexPolyhedron a, b;  // in the world
    Placed body_a, body_b;
};

// Two random polyhedra of radius 1 at most, near enough to overlap more often than not.
Pair random_pair(Random& random) {
    Pair pair;
    pair.body_a = placed(random.polyhedron(14), random.vector(-0.4, 0.4), random.rotation());
    pair.body_b =
        placed(random.polyhedron(10), random.direction() * random.uniform(0.2, 1.4), random.rotation());
    pair.a = transformed(std::get<ConvexPolyhedron>(pair.body_a.shape), pair.body_a.pose);
    pair.b = transformed(std::get<ConvexPolyhedron>(pair.body_b.shape), pair.body_b.pose);
    return pair;
}

// The part of a solid below a plane, as the hull of what is below it.
ConvexPolyhedron part_below(const ConvexPolyhedron& solid, const Plane& plane) {
    std::vector<Vec3> points;
    for (const std::vector<int>& face : loops(solid)) {
        std::vector<Vec3> polygon;
        for (const int v : face) {
            polygon.push_back(solid.vertices[static_cast<std::size_t>(v)]);
        }
        const std::vector<Vec3> kept = clip_polygon(polygon, plane);
        points.insert(points.end(), kept.begin(), kept.end());
    }
    return convex_hull(points).solid;
}

}  // namespace

TEST_CASE("V and c agree with a brute-force clip into tetrahedra", "[overlap]") {
    Random random(11);
    int overlapping = 0;
    for (int i = 0; i < 300; ++i) {
        const Pair pair = random_pair(random);
        const VolumeAndCentroid expected = brute_force_intersection(pair.a, pair.b);
        const auto g = overlap_of(pair.body_a, pair.body_b);
        // Of the size 1: rounding over the some hundred faces of the decomposition.
        CHECK(std::abs((g ? g->volume : 0) - expected.volume) < 1e-14);
        if (g && g->volume > 1e-6) {
            CHECK(deviation(g->centroid, expected.centroid, 1) < 1e-14 / g->volume + 1e-14);
            ++overlapping;
        }
    }
    CHECK(overlapping > 150);
}

TEST_CASE("S and its moments agree with A's faces clipped one by one", "[overlap]") {
    Random random(12);
    for (int i = 0; i < 300; ++i) {
        const Pair pair = random_pair(random);
        const auto g = overlap_of(pair.body_a, pair.body_b);
        if (!g) {
            continue;
        }
        Vec3 area_vector = Vec3::Zero();
        Mat3 first_moment = Mat3::Zero();
        Mat3 second_moment = Mat3::Zero();
        for_surface_inside(pair.a, pair.b, [&](const Vec3& point, const Vec3& area) {
            const Vec3 r = point - g->centroid;
            area_vector += area;
            first_moment += r * area.transpose();
            second_moment += r * r.cross(area).transpose();
        });
        CHECK(deviation(g->area_vector, area_vector, 1) < 1e-13);
        CHECK(deviation(g->first_moment, first_moment, 1) < 1e-13);
        CHECK(deviation(g->second_moment, second_moment, 1) < 1e-13);
    }
}

TEST_CASE("The halves of a body add up to the whole in V, V c and S", "[overlap]") {
    Random random(13);
    int split = 0;
    for (int i = 0; i < 200; ++i) {
        const Pair pair = random_pair(random);
        const auto whole = overlap_of(pair.body_a, pair.body_b);
        if (!whole || whole->volume < 1e-4) {
            continue;
        }
        const Vec3 normal = random.direction();
        const Plane plane{normal, normal.dot(whole->centroid)};
        double volume = 0;
        Vec3 moment = Vec3::Zero();
        Vec3 area_vector = Vec3::Zero();
        for (const double side : {1.0, -1.0}) {
            const auto half = overlap_of(
                placed(part_below(pair.a, {side * plane.normal, side * plane.offset}), Vec3::Zero()),
                pair.body_b);
            REQUIRE(half.has_value());
            volume += half->volume;
            moment += half->volume * half->centroid;
            area_vector += half->area_vector;  // the two sides of the cut cancel
        }
        // The hull of a half may move vertices by 10⁻¹² of the size.
        CHECK(volume == Approx(whole->volume).margin(1e-11));
        CHECK(deviation(moment, Vec3(whole->volume * whole->centroid), 1) < 1e-11);
        CHECK(deviation(area_vector, whole->area_vector, 1) < 1e-10);
        ++split;
    }
    CHECK(split > 80);
}
