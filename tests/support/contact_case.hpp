#pragma once

#include <array>
#include <limits>
#include <optional>

#include <scree/contact/built_in_law.hpp>
#include <scree/overlap/overlap.hpp>

#include <tests/support/random.hpp>
#include <tests/support/solids.hpp>

namespace scree::test {

/// All that a contact law sees, owned in one place and free to be changed. As it is made: a face of 10 by 10
/// cm on a half-space, sunk in by 0.1 mm, at rest, first order, a step of 1 ms.
struct ContactCase {
    ContactGeometry geometry;
    RelativeMotion motion;
    PairConstants pair;
    ContactHistory history;
    std::array<double, highest_order> past{1};
    std::size_t order = 1;
    double beta_h = 1e-3;
    std::array<Quat, highest_order> turn_a, turn_b;
    double cap = std::numeric_limits<double>::infinity();
    PairArms arms;
    LawOptions options;
    std::optional<PatchCells> cells;  ///< set: friction is on them

    ContactCase() {
        geometry.volume = 0.01 * 1e-4;
        geometry.area_vector = {0, 0, -0.01};
        geometry.area = 0.01;
        geometry.lever = 0.038;
        geometry.depth = 1e-4;
        geometry.flat_patch = true;
        // A's part of the surface is the face, half a depth under the centroid, and the four strips beside
        // it.
        geometry.first_moment = (geometry.volume * Vec3(1, 1, 0.5)).asDiagonal();
        const Mat3 spread = (0.01 * 0.01 / 12 * Vec3(1, 1, 0)).asDiagonal();
        geometry.second_moment = spread * cross_matrix(-Vec3::UnitZ());
        pair = pair_constants({1e7, 0.5, 0.5, 0.5, 2.0 / 7, true}, {2, 0.06}, {});
        turn_a.fill(Quat::Identity());
        turn_b.fill(Quat::Identity());
    }

    /// (Yt/Lc) ‖S‖ [N/m].
    [[nodiscard]] double patch_stiffness() const {
        return pair.tangential_stiffness * geometry.area / (pair.length * pair.length);
    }

    /// fn of a case at rest [N].
    [[nodiscard]] double normal_force() const { return pair.elastic * geometry.volume; }

    /// Stores a friction force [N] from one step ago, in the plane of the present normal.
    void remember(const Vec3& force) { history.push({force, geometry.normal}); }

    template <LawParts parts = LawParts{}>
    [[nodiscard]] ContactForce force(const MotionRates* rates = nullptr) const {
        const FrictionStep step{{std::span(past).first(order), beta_h}, turn_a, turn_b, cap};
        ContactForce out;
        BuiltInLaw<parts>{options}(
            {geometry, motion, pair, history, step, arms, rates, cells ? &*cells : nullptr}, out);
        return out;
    }

    /// The same by a friction law that is known when the test runs; torsion and rolling as the pair has them.
    [[nodiscard]] ContactForce force_by(FrictionLaw friction, const MotionRates* rates = nullptr) const {
        switch (friction) {
            case FrictionLaw::cundall_strack:
                return force<LawParts{.rolling = true}>(rates);
            case FrictionLaw::cundall_strack_2d:
                return force<LawParts{.friction = FrictionLaw::cundall_strack_2d, .rolling = true}>(rates);
            case FrictionLaw::viscous:
                return force<LawParts{.friction = FrictionLaw::viscous, .rolling = true}>(rates);
            default:
                return force<LawParts{.friction = FrictionLaw::none, .rolling = true}>(rates);
        }
    }
};

/// A face with an outline on a half-space, sunk in by 0.1 mm, with friction on its cells; else as a
/// ContactCase.
inline ContactCase face_on_cells(const ConvexPolyhedron& solid, double half_height) {
    ContactCase c;
    OverlapWorkspace workspace;
    const Pose pose{{0, 0, half_height - 1e-4}, Quat::Identity()};
    overlap(solid, pose, HalfSpace{}, {}, Detail::derivative, false, workspace, c.geometry);
    c.cells.emplace();
    if (!cut_into_cells(c.geometry, pose, workspace, *c.cells)) {
        c.cells.reset();
    }
    return c;
}

/// A random past for friction on the cells of the present patch.
inline void remember_on_cells(Random& random, double force, ContactCase& c) {
    for (std::size_t j = 0; j < c.history.age; ++j) {
        PatchRecord record;
        record.axis = c.history.past[j].normal.cross(random.vector()).normalized();
        for (Vec3& each : record.force) {
            each = force * random.vector();
        }
        for (std::size_t i = 0; i < PatchCells::count; ++i) {
            record.slipping[i] = random.uniform() < 0.3;
        }
        c.history.patch.push_back(record);
    }
    c.history.patch_age = c.history.age;
}

/// A contact of two random polyhedra with random motion, past and turns: half of them slip, some have no
/// force.
inline ContactCase random_case(Random& random, bool on_cells = false) {
    ContactCase c;
    OverlapWorkspace workspace;
    do {
        const Pose at{random.direction() * random.uniform(0.05, 0.15), random.rotation()};
        const ConvexPolyhedron a = random.polyhedron(12, 0.1);
        const ConvexPolyhedron b = random.polyhedron(12, 0.1);
        if (!overlap(a, {}, b, at, Detail::derivative, false, workspace, c.geometry)) {
            c.geometry.volume = 0;
        }
    } while (c.geometry.volume < 1e-8 || c.geometry.centre_line);
    c.pair = pair_constants({1e7, 0.4, 0.3, 0.6, 2.0 / 7, true}, {2, 0.06, 2e-3 * Vec3(1, 1.5, 2)},
                            {3, 0.07, 4e-3 * Vec3(1.6, 1, 1.2)});
    c.order = 2;
    c.past = {4.0 / 3, -1.0 / 3};
    const double force = c.pair.friction * c.normal_force();
    const double speed = force / (c.pair.tangential_stiffness * c.beta_h);
    c.motion = {speed * random.vector(), speed / c.geometry.lever * random.vector()};
    for (int i = 0; i < 2; ++i) {
        const Vec3 normal = (c.geometry.normal + 0.1 * random.vector()).normalized();
        c.history.push({force * random.vector(), normal, random.uniform(0.5, 2) * c.patch_stiffness()});
        c.turn_a[static_cast<std::size_t>(i)] = rotation(0.1 * random.vector());
        c.turn_b[static_cast<std::size_t>(i)] = rotation(0.1 * random.vector());
    }
    if (on_cells) {
        c.cells.emplace();
        c.cells->axis = c.geometry.normal.unitOrthogonal();
        if (!cut_into_cells(c.geometry, {}, workspace, *c.cells)) {
            c.cells.reset();
        }
        remember_on_cells(random, force, c);
    }
    c.arms = {0.06 * random.vector(), 0.07 * random.vector(), random.rotation(), random.rotation()};
    return c;
}

}  // namespace scree::test
