#include <cstring>
#include <vector>

#include <catch2/catch.hpp>

#include <tests/contact/law_path.hpp>

using namespace scree;
using namespace scree::test;

namespace {

// Every number of an answer.
std::vector<double> numbers(const ContactForce& out) {
    std::vector<double> all{out.normal_force,
                            static_cast<double>(out.state),
                            static_cast<double>(out.lost_direction),
                            out.power.normal_elastic,
                            out.power.normal_damping,
                            out.power.tangential,
                            out.power.tangential_damping,
                            out.power.torsion,
                            out.power.rolling,
                            out.normal_energy,
                            out.tangential_energy,
                            out.torsional_energy,
                            out.rolling_energy};
    const auto add = [&](const auto& m) { all.insert(all.end(), m.data(), m.data() + m.size()); };
    add(out.force);
    add(out.moment);
    add(out.trial.force);
    add(out.trial.normal);
    add(out.force_rate);
    add(out.moment_rate);
    return all;
}

bool same_bytes(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

}  // namespace

TEST_CASE("The law is pure: asked again, in any order, it gives the same bytes", "[contact]") {
    Random random(131);
    std::vector<ContactCase> cases;
    std::vector<MotionRates> rates;
    std::vector<std::vector<double>> answers;
    for (int i = 0; i < 60; ++i) {
        cases.push_back(random_case(random));
        rates.push_back(LawPath(random, cases.back()).rates(cases.back()));
    }
    for (std::size_t i = 0; i < cases.size(); ++i) {
        answers.push_back(numbers(cases[i].force(&rates[i])));
    }
    for (int i = 0; i < 1000; ++i) {
        const auto pick = static_cast<std::size_t>(random.uniform() * static_cast<double>(cases.size()));
        CHECK(same_bytes(numbers(cases[pick].force(&rates[pick])), answers[pick]));
    }
}

TEST_CASE("The law leaves its input as it was, the history to the last byte", "[contact]") {
    Random random(132);
    for (int i = 0; i < 50; ++i) {
        const ContactCase c = random_case(random);
        std::vector<unsigned char> before(sizeof(ContactHistory));
        std::memcpy(before.data(), &c.history, before.size());
        const ContactForce out = c.force();
        CHECK(std::memcmp(before.data(), &c.history, before.size()) == 0);
        CHECK(out.state != ContactState::open);
    }
}

TEST_CASE("Asking for derivatives does not change the force", "[contact]") {
    Random random(133);
    for (int i = 0; i < 50; ++i) {
        const ContactCase c = random_case(random);
        const MotionRates rates = LawPath(random, c).rates(c);
        const ContactForce with = c.force(&rates);
        const ContactForce without = c.force();
        CHECK(with.force == without.force);
        CHECK(with.moment == without.moment);
        CHECK(with.trial.force == without.trial.force);
    }
}

TEST_CASE("What an answer held before does not matter", "[contact]") {
    Random random(134);
    const ContactCase first = random_case(random);
    const ContactCase second = random_case(random);
    ContactForce out;
    const auto ask = [&](const ContactCase& c) {
        const FrictionStep step{{std::span(c.past).first(c.order), c.beta_h}, c.turn_a, c.turn_b, c.cap};
        BuiltInLaw<LawParts{}>{}({c.geometry, c.motion, c.pair, c.history, step, c.arms, nullptr}, out);
        return numbers(out);
    };
    const std::vector<double> fresh = ask(second);
    ask(first);
    CHECK(same_bytes(ask(second), fresh));
}
