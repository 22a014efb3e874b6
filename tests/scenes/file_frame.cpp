#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>

#include <scree/scenes/read_scene.hpp>
#include <scree/scenes/simulation.hpp>

#include <tests/support/solids.hpp>

using namespace scree;
using namespace scree::test;

namespace {

namespace fs = std::filesystem;

/// A folder that goes when the test ends.
class Folder {
  public:
    Folder() : path_(fs::temp_directory_path() / "scree_file_frame") { fs::create_directories(path_); }
    ~Folder() { fs::remove_all(path_); }
    [[nodiscard]] const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

const Vec3 edges(0.5, 0.25, 1);
const Vec3 centre(3, -2, 1);

/// A box that is neither at the origin of its file nor along the file's axes.
void write_box(const fs::path& file, const Quat& turn) {
    const ConvexPolyhedron box = make_box(edges);
    std::ofstream stream(file);
    stream.precision(17);
    for (const Vec3& vertex : box.vertices) {
        stream << "v " << (turn * vertex + centre).transpose() << "\n";
    }
    for (const std::vector<int>& loop : loops(box)) {
        for (std::size_t i = 2; i < loop.size(); ++i) {
            stream << "f " << loop[0] + 1 << " " << loop[i - 1] + 1 << " " << loop[i] + 1 << "\n";
        }
    }
}

SceneDescription scene_in(const fs::path& folder) {
    return parse_scene(R"({
        "gravity": [0, 0, 0],
        "materials": {"rock": {"density": 1000, "youngs_modulus": 1e9, "friction": 0.5}},
        "shapes": {"stone": {"mesh": "box.obj", "scale": 2}},
        "bodies": [{"name": "stone", "shape": "stone", "material": "rock", "position": [10, 20, 30],
                    "orientation": [0.5, 0.5, 0.5, 0.5], "velocity": [1, 2, 3], "angular_velocity": [0, 0, 0.7]}],
        "end_time": 0.5, "output": {"every": 0.25}
    })",
                       folder / "scene.json");
}

}  // namespace

TEST_CASE("Position, orientation and velocity are those of the file's own frame", "[scenes]") {
    const Folder folder;
    const Quat turn = turned(0.7, Vec3(1, 2, -1));
    write_box(folder.path() / "box.obj", turn);
    const Simulation simulation(scene_in(folder.path()));

    // Exactly what the scene says.
    const FrameMotion file = simulation.file_motion(0);
    CHECK(file.pose.position == Vec3(10, 20, 30));
    CHECK(file.pose.orientation.coeffs() == Quat(0.5, 0.5, 0.5, 0.5).coeffs());
    CHECK(file.velocity == Vec3(1, 2, 3));

    // The cyclic turn of the axes takes the centre (3, −2, 1) times 2 to (2, 6, −4).
    const FrameMotion body = simulation.body_motion(0);
    const Vec3 arm(2, 6, -4);
    const double float_size = 1e-6;  // mesh files are read in single precision
    CHECK((body.pose.position - Vec3(10, 20, 30) - arm).norm() < float_size);
    CHECK((body.velocity - Vec3(1, 2, 3) - Vec3(0, 0, 0.7).cross(arm)).norm() < float_size);
    CHECK(body.angular_velocity == Vec3(0, 0, 0.7));
}

TEST_CASE("Mass and inertia are those of the mesh, in its principal frame", "[scenes]") {
    const Folder folder;
    write_box(folder.path() / "box.obj", turned(0.7, Vec3(1, 2, -1)));
    const Simulation simulation(scene_in(folder.path()));
    const btRigidBody& rigid = *simulation.bodies()[0].rigid;
    const double mass = 1000;  // a box 1 by 0.5 by 2
    CHECK(1 / rigid.getInvMass() == Approx(mass).epsilon(1e-6));
    const btVector3& inverse = rigid.getInvInertiaDiagLocal();
    std::array moments = {1 / inverse.x(), 1 / inverse.y(), 1 / inverse.z()};
    std::sort(moments.begin(), moments.end());
    CHECK(moments[0] == Approx(mass / 12 * (1 + 0.25)).epsilon(1e-6));
    CHECK(moments[1] == Approx(mass / 12 * (0.25 + 4)).epsilon(1e-6));
    CHECK(moments[2] == Approx(mass / 12 * (1 + 4)).epsilon(1e-6));

    // All corners are where the file's frame puts them.
    const auto& solid = std::get<ConvexPolyhedron>(*simulation.bodies()[0].solid.shape);
    const Vec3 half = edges;  // scale 2
    for (const Vec3& vertex : solid.vertices) {
        CHECK(vertex.norm() == Approx(half.norm()).epsilon(1e-6));
    }
}

TEST_CASE("A free body's file frame goes round its mass centre", "[scenes]") {
    const Folder folder;
    write_box(folder.path() / "box.obj", Quat::Identity());
    Simulation simulation(scene_in(folder.path()));
    const Vec3 velocity = simulation.body_motion(0).velocity;
    const Vec3 start = simulation.body_motion(0).pose.position;
    REQUIRE(simulation.advance());
    REQUIRE(simulation.advance());
    CHECK(simulation.time() == 0.5);
    const FrameMotion body = simulation.body_motion(0);
    const FrameMotion file = simulation.file_motion(0);
    CHECK((body.pose.position - start - 0.5 * velocity).norm() < 1e-9);
    const Vec3 arm = body.pose.position - file.pose.position;
    CHECK(arm.norm() == Approx(2 * centre.norm()).epsilon(1e-6));
    CHECK((file.velocity + file.angular_velocity.cross(arm) - velocity).norm() < 1e-9);
    CHECK(file.pose.orientation.dot(Quat(0.5, 0.5, 0.5, 0.5)) > 0.9);  // no change of sign on the way
}

TEST_CASE("A prescribed body's file frame is exactly where its motion leads, and its mass centre goes along",
          "[scenes]") {
    const Folder folder;
    write_box(folder.path() / "box.obj", turned(0.7, Vec3(1, 2, -1)));
    SceneDescription scene = scene_in(folder.path());
    BodyDescription& stone = scene.bodies[0];
    stone.velocity = stone.angular_velocity = Vec3::Zero();
    PrescribedMotion motion;
    motion.velocity = {1, 2, 3};
    motion.angular_velocity = {0.5, 0, -1};
    motion.about = {1, 1, 1};
    stone.motion = motion;
    Simulation simulation(scene);
    const PrescribedMotionPath path(motion, {stone.position, stone.orientation});
    CHECK(simulation.file_motion(0).velocity == path.at(0).velocity);
    while (simulation.tick() < simulation.times().last()) {
        REQUIRE(simulation.advance());
        const PathPoint point = path.at(simulation.time());
        const FrameMotion file = simulation.file_motion(0);
        CHECK(file.pose.position == point.pose.position);
        CHECK(file.pose.orientation.coeffs() == point.pose.orientation.coeffs());
        CHECK(file.velocity == point.velocity);
        CHECK(file.angular_velocity == motion.angular_velocity);

        // The world's body, in the frame of its mass centre.
        const FrameMotion body = simulation.body_motion(0);
        const BodyState& state = simulation.world().system().states[0];
        CHECK((state.position - body.pose.position).norm() < 1e-13);
        CHECK((state.momentum - body.velocity).norm() < 1e-13);
        CHECK(std::abs(state.orientation.dot(body.pose.orientation)) == Approx(1).epsilon(1e-14));
    }
}
