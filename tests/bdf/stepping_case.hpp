#pragma once

#include <memory>

#include <scree/bdf/stepper.hpp>
#include <scree/mesh/mass_properties.hpp>

namespace scree::test {

/// A system of a few bodies over fixed ground, with the shapes that it points to.
struct SteppingCase {
    System system;
    std::vector<std::unique_ptr<Shape>> shapes;
    double gravity = 0;
    EnergyAccount account;
    ForcesOf<BuiltInLaw<LawParts{}>> forces{BuiltInLaw<LawParts{}>{}};

    int add_ground(Shape shape) {
        shapes.push_back(std::make_unique<Shape>(std::move(shape)));
        system.bodies.emplace_back();
        system.states.emplace_back();
        return static_cast<int>(system.bodies.size()) - 1;
    }
    int add_box(const Vec3& edges, double density, const Vec3& position) {
        shapes.push_back(std::make_unique<Shape>(make_box(edges)));
        const MassProperties mass = mass_properties(std::get<ConvexPolyhedron>(*shapes.back()));
        Body body;
        body.mass = density * mass.volume;
        body.inertia = density * mass.inertia.diagonal();
        body.radius = sphere_radius(mass.volume);
        body.weight = -body.mass * gravity * Vec3::UnitZ();
        system.bodies.push_back(body);
        BodyState state;
        state.position = position;
        system.states.push_back(state);
        return static_cast<int>(system.bodies.size()) - 1;
    }
    [[nodiscard]] BodySize size(int body) const {
        return body_size(system.bodies[static_cast<std::size_t>(body)]);
    }
    PairConstants& touch(int a, int b, const PairMaterial& material) {
        Contact contact;
        contact.a = {a, shapes[static_cast<std::size_t>(a)].get(), {}};
        contact.b = {b, shapes[static_cast<std::size_t>(b)].get(), {}};
        contact.pair = pair_constants(material, size(a), size(b));
        system.contacts.push_back(contact);
        return system.contacts.back().pair;
    }
    /// In one go, to `end`, with ticks of `tick` [s]. Null: a step could not be made.
    std::unique_ptr<Integrator> run(double end, SteppingOptions options, double tick) {
        options.tolerances.gravity = gravity;
        auto integrator = make_integrator(system, forces, options);
        integrator->restart(0);
        account.open(system);
        const auto ticks = static_cast<int>(std::lround(end / tick));
        for (int i = 1; i <= ticks; ++i) {
            while (integrator->time() < i * tick) {
                if (integrator->step(i * tick) != StepOutcome::accepted) {
                    return nullptr;
                }
            }
        }
        account.settle(system, integrator->flows());
        return integrator;
    }
};

}  // namespace scree::test
