// The same motions by CVODE, which knows nothing of contacts: it is given positions, momenta and friction
// forces as the states of a differential equation, whose right-hand side is one evaluation of the contact
// law.

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <memory>

#include <catch2/catch.hpp>
#include <tests/bdf/known_motions.hpp>

using namespace scree;
using namespace scree::test;

namespace {

constexpr double duration = 0.2;  // [s]
constexpr int body_values = 13;   // x, p, q, L
constexpr int values = body_values + 3;

using Values = Eigen::Map<Eigen::Matrix<double, values, 1>>;

// The last body of a case, and the friction of its only contact.
class Equation {
  public:
    explicit Equation(SteppingCase& scene)
        : scene_(scene), problem_(scene.system, scene.forces), body_(scene.system.bodies.size() - 1) {}

    void start(Values y) const {
        const BodyState& state = scene_.system.states[body_];
        y << state.position, state.momentum, state.orientation.coeffs(), state.angular_momentum, Vec3::Zero();
    }
    void put(const Values& y) {
        BodyState& state = scene_.system.states[body_];
        state.position = y.segment<3>(0);
        state.momentum = y.segment<3>(3);
        state.orientation = Quat(Eigen::Vector4d(y.segment<4>(6))).normalized();
        state.angular_momentum = y.segment<3>(10);
        for (Contact& contact : scene_.system.contacts) {
            contact.history = {};
            FrictionRecord record;
            record.force = y.segment<3>(body_values);
            record.normal = Vec3::UnitZ();
            record.stiffness = contact.pair.tangential_stiffness;
            contact.history.push(record);
        }
    }
    void rates(const Values& y, Values rate) {
        put(y);
        evaluate();
        const TrialBody& now = problem_.trial()[body_];
        const Eigen::Vector4d q = y.segment<4>(6);
        const Quat turn = Quat(0, 0.5 * now.spin.x(), 0.5 * now.spin.y(), 0.5 * now.spin.z()) * Quat(q);
        rate << now.velocity, problem_.forces()[body_], turn.coeffs(), problem_.torques()[body_],
            friction_rate(now);
    }

  private:
    // In the present state, in which no time passes.
    void evaluate() {
        StepFormulas formulas;
        formulas.past[0][0] = 1;
        std::vector<BodyStart> starts(scene_.system.bodies.size());
        Eigen::VectorXd u(static_cast<Eigen::Index>(6 * starts.size()));
        for (std::size_t b = 0; b < starts.size(); ++b) {
            const BodyState& state = scene_.system.states[b];
            starts[b].position = state.position;
            starts[b].orientation = state.orientation.coeffs();
            starts[b].past_orientations[0] = state.orientation;
            u.segment<3>(static_cast<Eigen::Index>(6 * b)) = velocity(scene_.system.bodies[b], state);
            u.segment<3>(static_cast<Eigen::Index>(6 * b + 3)) = spin(scene_.system.bodies[b], state);
        }
        problem_.begin(formulas, starts);
        problem_.evaluate(u, Detail::force);
    }
    // Eq. (5.15), on a plane that stands still.
    [[nodiscard]] Vec3 friction_rate(const TrialBody& now) const {
        if (problem_.results().empty() || scene_.system.contacts[0].pair.friction == 0) {
            return Vec3::Zero();
        }
        const ContactResult& contact = problem_.results()[0];
        const Vec3 slip = now.velocity + now.spin.cross(contact.point - now.pose.position);
        const Vec3 across = slip - slip.dot(contact.normal) * contact.normal;
        return scene_.system.contacts[0].pair.tangential_stiffness * across;  // on the plane, which is A
    }

    SteppingCase& scene_;
    StepProblem problem_;
    std::size_t body_;
};

int right_hand_side(double /*time*/, N_Vector y, N_Vector rate, void* equation) {
    static_cast<Equation*>(equation)->rates(Values(N_VGetArrayPointer(y)), Values(N_VGetArrayPointer(rate)));
    return 0;
}

// In the units in which scree measures its errors.
void fill_tolerances(const SteppingCase& scene, double rtol, Values allowed) {
    const Body& body = scene.system.bodies.back();
    const BodyState& state = scene.system.states.back();
    const double size = body.radius;
    const double speed = std::max(velocity(body, state).norm(), std::sqrt(scene.gravity * size));
    const double turning = std::max(spin(body, state).norm(), std::sqrt(scene.gravity / size));
    const double stiffness =
        scene.system.contacts.empty() ? 1 : scene.system.contacts[0].pair.tangential_stiffness;
    allowed.segment<3>(0).setConstant(rtol * size);
    allowed.segment<3>(3).setConstant(rtol * body.mass * speed);
    allowed.segment<4>(6).setConstant(0.5 * rtol);
    allowed.segment<3>(10).setConstant(rtol * body.inertia.mean() * turning);
    allowed.segment<3>(13).setConstant(rtol * size * stiffness);
}

template <auto release>
struct Release {
    void operator()(auto* what) const { release(what); }
};
void free_memory(void* memory) {
    CVodeFree(&memory);
}
void free_context(SUNContext context) {
    SUNContext_Free(&context);
}

// Where CVODE leaves the body.
BodyState by_cvode(SteppingCase scene, double rtol, int order) {
    SUNContext made = nullptr;
    REQUIRE(SUNContext_Create(nullptr, &made) == 0);
    const std::unique_ptr<std::remove_pointer_t<SUNContext>, Release<free_context>> context(made);
    using Vector = std::unique_ptr<std::remove_pointer_t<N_Vector>, Release<N_VDestroy>>;
    const Vector y(N_VNew_Serial(values, made));
    const Vector allowed(N_VNew_Serial(values, made));
    Equation equation(scene);
    equation.start(Values(N_VGetArrayPointer(y.get())));
    fill_tolerances(scene, rtol, Values(N_VGetArrayPointer(allowed.get())));

    const std::unique_ptr<std::remove_pointer_t<SUNMatrix>, Release<SUNMatDestroy>> matrix(
        SUNDenseMatrix(values, values, made));
    const std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, Release<SUNLinSolFree>> solver(
        SUNLinSol_Dense(y.get(), matrix.get(), made));
    const std::unique_ptr<void, Release<free_memory>> memory(CVodeCreate(CV_BDF, made));
    REQUIRE(CVodeInit(memory.get(), right_hand_side, 0, y.get()) == CV_SUCCESS);
    REQUIRE(CVodeSVtolerances(memory.get(), 0, allowed.get()) == CV_SUCCESS);
    REQUIRE(CVodeSetUserData(memory.get(), &equation) == CV_SUCCESS);
    REQUIRE(CVodeSetLinearSolver(memory.get(), solver.get(), matrix.get()) == CV_SUCCESS);
    REQUIRE(CVodeSetMaxOrd(memory.get(), order) == CV_SUCCESS);
    REQUIRE(CVodeSetMaxNumSteps(memory.get(), 10'000'000) == CV_SUCCESS);
    double reached = 0;
    REQUIRE(CVode(memory.get(), duration, y.get(), &reached, CV_NORMAL) == CV_SUCCESS);
    equation.put(Values(N_VGetArrayPointer(y.get())));
    return scene.system.states.back();
}

BodyState by_scree(SteppingCase scene, double rtol, std::size_t order) {
    SteppingOptions options;
    options.tolerances.relative = rtol;
    options.tolerances.absolute = 0;
    options.max_order = order;
    REQUIRE(scene.run(duration, options, duration) != nullptr);
    return scene.system.states.back();
}

SteppingCase flying_top() {
    SteppingCase scene = top();
    scene.system.states[0].momentum = Vec3(1, -2, 0.5);
    return scene;
}

// As hard as rock: it slides and spins over ice, and heaves by a fifth of what it is sunk in.
SteppingCase hard_cube_on_ice() {
    SteppingCase scene = pressed_cube(0, 1e10);
    const Body& body = scene.system.bodies[1];
    scene.system.states[1].momentum = mass * Vec3(1, 0.5, 2e-5);
    scene.system.states[1].angular_momentum = 5 * body.inertia.z() * Vec3::UnitZ();
    scene.system.bodies[1].force = mass * Vec3(0, 2, 0);
    return scene;
}

// In the x–z plane, where friction has no torsion.
SteppingCase swinging_cube() {
    SteppingCase scene = pressed_cube(10);
    scene.system.states[1].momentum.x() = 0.03 * mass;
    return scene;
}

}  // namespace

TEST_CASE("CVODE comes to the same motions, free, in stiff and in soft contact, and held by friction",
          "[cvode]") {
    for (const auto scene : {flying_top, floating_cube, hard_cube_on_ice, swinging_cube}) {
        const BodyState cvode = by_cvode(scene(), 1e-10, 5);
        CHECK(distance(by_scree(scene(), 1e-9, 2), cvode) < 1e-7);
    }
}

TEST_CASE("The error is at most ten times CVODE's at the same tolerance and highest order", "[cvode]") {
    int number = 0;
    for (const auto scene : {flying_top, floating_cube, hard_cube_on_ice, swinging_cube}) {
        const BodyState exact = by_cvode(scene(), 1e-11, 5);
        for (const double rtol : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
            const double theirs = distance(by_cvode(scene(), rtol, 2), exact);
            const double ours = distance(by_scree(scene(), rtol, 2), exact);
            CAPTURE(number, rtol, ours / rtol, theirs / rtol);
            CHECK(ours <= 10 * std::max(theirs, 0.1 * rtol));
        }
        ++number;
    }
}
