#include <catch2/catch.hpp>

#include <tests/support/overlaps.hpp>
#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

namespace {

struct Pair {
    Placed a, b;
};

std::vector<Pair> pairs() {
    Random random(61);
    const Placed first = placed(random.polyhedron(12), {0.25, 0.5, -0.125}, random.rotation());
    const Placed second =
        placed(random.polyhedron(14), first.pose.position + Vec3(0.5, -0.25, 0.75), random.rotation());
    return {{first, second},
            {placed(cube(1), {0.25, 0.5, 0.9921875}, turned(0.3, Vec3::UnitZ())), placed(cube(1), {0, 0, 0})},
            {placed(cube(1), {0.25, 0.5, 0.4921875}), ground()},
            {placed(Sphere{0.5}, {0.25, 0.5, 0.4375}), ground()},
            {placed(Sphere{0.5}, {0.25, 0.5, 0.4375}), placed(Sphere{0.25}, {0, 0.25, 0})}};
}

// Compares two geometries of size one, the second's world axes turned and its lengths scaled.
void check_same(const ContactGeometry& g, ContactGeometry other, const Mat3& turn, double scale,
                double error) {
    rotate(other, turn.transpose());
    const double area = scale * scale;
    CHECK(std::abs(other.volume / (area * scale) - g.volume) < error);
    CHECK(deviation(other.area_vector / area, g.area_vector, 1) < error);
    CHECK(deviation(other.first_moment / (area * scale), g.first_moment, 1) < error);
    CHECK(deviation(other.second_moment / (area * area), g.second_moment, 1) < error);
    // A thin overlap's centroid and depth move by no more than the bodies do over its thinness.
    const double of_volume = 10 * error / g.volume;
    CHECK(deviation(other.centroid / scale, g.centroid, 1) < of_volume);
    CHECK(deviation(other.normal, g.normal, 1) < of_volume);
    CHECK(std::abs(other.depth / scale - g.depth) < of_volume);
    CHECK(std::abs(other.lever / scale - g.lever) < of_volume);
    const double rates = g.normal_rate.cwiseAbs().maxCoeff() + 1;
    CHECK(deviation(other.normal_rate.leftCols<3>() * scale, g.normal_rate.leftCols<3>(), rates) <
          10 * of_volume);
    CHECK(deviation(other.normal_rate.rightCols<3>(), g.normal_rate.rightCols<3>(), rates) < 10 * of_volume);
    const double lines = g.boundary.cwiseAbs().maxCoeff() + 1;
    CHECK(deviation(other.boundary.topLeftCorner<3, 3>() / scale, g.boundary.topLeftCorner<3, 3>(), lines) <
          10 * of_volume);
    CHECK(deviation(other.boundary.bottomRightCorner<3, 3>() / (area * scale),
                    g.boundary.bottomRightCorner<3, 3>(), lines) < 10 * of_volume);
}

// The overlap with the centroid relative to A.
ContactGeometry relative_to_a(const Placed& a, const Placed& b) {
    ContactGeometry g = overlap_of(a, b).value();
    g.centroid -= a.pose.position;
    return g;
}

Placed scaled(const Placed& body, double factor) {
    Placed other{body.shape, {factor * body.pose.position, body.pose.orientation}};
    if (auto* solid = std::get_if<ConvexPolyhedron>(&other.shape)) {
        *solid = scree::test::scaled(*solid, factor);
    } else if (auto* sphere = std::get_if<Sphere>(&other.shape)) {
        sphere->radius *= factor;
    }
    return other;
}

}  // namespace

TEST_CASE("A common rigid motion turns the contact and changes nothing else", "[overlap]") {
    Random random(62);
    for (const Pair& pair : pairs()) {
        const ContactGeometry g = relative_to_a(pair.a, pair.b);
        for (int i = 0; i < 20; ++i) {
            const Pose motion{random.vector(), random.rotation()};
            const ContactGeometry other = relative_to_a(moved(pair.a, motion), moved(pair.b, motion));
            check_same(g, other, motion.orientation.toRotationMatrix(), 1, 1e-14);
        }
    }
}

TEST_CASE("A shift by 2²⁰ m that positions can hold exactly changes no bit", "[overlap]") {
    for (const Pair& pair : pairs()) {
        const ContactGeometry g = relative_to_a(pair.a, pair.b);
        const Pose far{0x1p20 * Vec3(1, -2, 3), Quat::Identity()};
        OverlapWorkspace workspace;
        ContactGeometry other;
        const Placed a = moved(pair.a, far);
        Placed b = moved(pair.b, far);
        REQUIRE(overlap(a.shape, a.pose, b.shape, b.pose, Detail::derivative, false, workspace, other));
        OverlapWorkspace again;
        ContactGeometry near;
        REQUIRE(overlap(pair.a.shape, pair.a.pose, pair.b.shape, pair.b.pose, Detail::derivative, false,
                        again, near));
        CHECK(other.volume == near.volume);
        CHECK(other.centroid == near.centroid);
        CHECK(other.area_vector == near.area_vector);
        CHECK(other.boundary == near.boundary);
        CHECK(other.normal_rate == near.normal_rate);
        check_same(g, near, Mat3::Identity(), 1, 1e-15);
    }
}

TEST_CASE("A million metres away the contact is right to the noise of its positions", "[overlap]") {
    Random random(63);
    const double noise = 2 * 0x1p-53 * 2e6;  // two positions, rounded at 2·10⁶ m
    for (const Pair& pair : pairs()) {
        const ContactGeometry g = relative_to_a(pair.a, pair.b);
        const Pose far{1e6 * random.direction(), random.rotation()};
        const ContactGeometry other = relative_to_a(moved(pair.a, far), moved(pair.b, far));
        // Areas of size one turn the shift into a volume.
        check_same(g, other, far.orientation.toRotationMatrix(), 1, 4 * noise);
    }
}

TEST_CASE("The same pair at any size from 10⁻⁶ to 10³ gives the same contact", "[overlap]") {
    for (const Pair& pair : pairs()) {
        const ContactGeometry g = relative_to_a(pair.a, pair.b);
        for (const double factor : {1e-6, 1e-3, 0.1, 10.0, 1e3}) {
            const ContactGeometry other = relative_to_a(scaled(pair.a, factor), scaled(pair.b, factor));
            CHECK(other.centre_line == g.centre_line);
            CHECK(other.flat_patch == g.flat_patch);
            check_same(g, other, Mat3::Identity(), factor, 1e-14);
        }
        // Powers of two scale every number exactly.
        for (const double factor : {0x1p-20, 0x1p10}) {
            const ContactGeometry other = relative_to_a(scaled(pair.a, factor), scaled(pair.b, factor));
            CHECK(other.volume == factor * factor * factor * g.volume);
            CHECK(other.area_vector == factor * factor * g.area_vector);
            CHECK(other.normal == g.normal);
        }
    }
}

TEST_CASE("Without derivatives the geometry is the same, only boundary and normal rate are left out",
          "[overlap]") {
    for (const Pair& pair : pairs()) {
        const ContactGeometry full = overlap_of(pair.a, pair.b).value();
        const ContactGeometry force = overlap_of(pair.a, pair.b, false, Detail::force).value();
        CHECK(force.volume == full.volume);
        CHECK(force.centroid == full.centroid);
        CHECK(force.area_vector == full.area_vector);
        CHECK(force.normal == full.normal);
        CHECK(force.lever == full.lever);
        CHECK(force.depth == full.depth);
        CHECK(force.first_moment == full.first_moment);
        CHECK(force.second_moment == full.second_moment);
    }
}
