#include <algorithm>

#include <catch2/catch.hpp>

#include "small_scene.hpp"

using namespace scree;
using namespace scree::test;

namespace {

/// The one line that refuses a scene; empty when it is accepted.
std::string refusal(const std::string& text, const std::vector<std::string>& settings = {}) {
    try {
        parse_scene(text, "small.json", settings);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

struct BadText {
    const char* text;
    const char* message;
};

const BadText bad_texts[] = {
    {"", "small.json:1: found end of input, expected"},
    {"{", "small.json:1: found end of input, expected"},
    {"{\n\"end_time\": 1,\n}", "small.json:3: found '}', expected string literal"},
    {"{\n\n\"end_time\": tru}", "small.json:3: found invalid literal"},
    {"{\"end_time\": 1} {", "small.json:1: found '{', expected end of input"},
    {"{\"end_time\": 1e999}", "small.json:1: found a number that is too large, expected a double"},
    {"{\"end_time\": NaN}", "small.json:1: found invalid literal"},
    {"{\"a\nb\": 1}", "small.json:1: found invalid string"},
    {"{\"\xff\": 1}", "small.json:1: found invalid string"},
    {"{} // comment \n /* without end", "small.json:2: found invalid comment"},
    {"[]", "small.json: found [], expected an object"},
    {"3", "small.json: found 3, expected an object"},
    {"{}", "small.json: found no \"materials\", expected that key"},
    {"{\"end_time\": 1, \"end_time\": 1}", "small.json: end_time: found the key twice"},
    {"{\"law\": {\"normal\": 1, \"normal\": 1}}", "small.json: law.normal: found the key twice"},
    {"{\"bodies\": [{}, {\"name\": 1, \"name\": 1}]}", "small.json: bodies.1.name: found the key twice"},
    {"[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[", "found a value nested 17 deep, expected 16 at most"},
};

struct BadSetting {
    const char* setting;
    const char* message;
};

const BadSetting bad_settings[] = {
    // Unknown keys name the nearest known one.
    {"gravitty=[0,0,0]", "gravitty: found an unknown key, expected \"gravity\""},
    {"law.frictoin=none", "law.frictoin: found an unknown key, expected \"friction\""},
    {"stepping.stp=1", "stepping.stp: found an unknown key, expected \"step\""},
    {"output.evry=1", "output.evry: found an unknown key, expected \"every\""},
    {"materials.rock.youngs_moduls=1",
     "materials.rock.youngs_moduls: found an unknown key, expected "
     "\"youngs_modulus\""},
    {"bodies.1.pos=1", "bodies.1.pos: found an unknown key, expected \"position\""},
    {"shapes.ball.radius=1", "shapes.ball.radius: found an unknown key"},
    {"shapes.ball.scale=2", "shapes.ball.scale: found an unknown key"},
    {"shapes.floor.half_space.ofset=1",
     "shapes.floor.half_space.ofset: found an unknown key, expected "
     "\"offset\""},
    // Wrong kinds.
    {"gravity=9.81", "gravity: found 9.81, expected a list of 3 numbers"},
    {"gravity=[0,0]", "gravity: found [0,0], expected a list of 3 numbers"},
    {"gravity=[0,0,down]", "gravity: found \"[0,0,down]\", expected a list of 3 numbers"},
    {"gravity=[0,0,\"down\"]", "gravity.2: found \"down\", expected a number"},
    {"gravity=null", "gravity: found null, expected"},
    {"materials=[]", "materials: found [], expected an object"},
    {"materials.rock=3", "materials.rock: found 3, expected an object"},
    {"materials.rock.friction=rough", "materials.rock.friction: found \"rough\", expected a number"},
    {"materials.rock.torsion=1", "materials.rock.torsion: found 1, expected true, false or \"patch\""},
    {"bodies={}", "bodies: found an object, expected a list"},
    {"bodies.1.name=7", "bodies.1.name: found 7, expected a name"},
    {"bodies.1.motion=stuck", "bodies.1.motion: found \"stuck\", expected \"dynamic\", \"fixed\" or"},
    {"law.co_rotation=1", "law.co_rotation: found 1, expected true or false"},
    {"law.normal_damping=1", "law.normal_damping: found 1, expected one of \"length\", \"patch\""},
    {"law.normal=hertz", "law.normal: found \"hertz\", expected one of \"volume\""},
    {"stepping.step=fast", "stepping.step: found \"fast\", expected \"adaptive\" or a number above 0"},
    {"stepping.max_order=1.5", "stepping.max_order: found 1.5, expected a whole number from 1 to 5"},
    {"output.bodies=yes", "output.bodies: found \"yes\", expected true or false"},
    {"end_time=\"2\"", "end_time: found \"2\", expected a number"},
    // Out of range.
    {"end_time=0", "end_time: found 0, expected a number above 0"},
    {"end_time=1e300", "end_time: found 1e+300, expected a number"},
    {"materials.rock.density=0", "materials.rock.density: found 0, expected a number above 0"},
    {"materials.rock.youngs_modulus=-1", "materials.rock.youngs_modulus: found -1, expected"},
    {"materials.rock.friction=-0.1", "materials.rock.friction: found -0.1, expected a number not below 0"},
    {"materials.rock.tangential_ratio=0", "materials.rock.tangential_ratio: found 0, expected"},
    {"shapes.crate.box=[1,1,0]", "shapes.crate.box.2: found 0, expected a number above 0"},
    {"shapes.ball.sphere=-1", "shapes.ball.sphere: found -1, expected a number above 0"},
    {"shapes.floor.half_space.normal=[0,0,0]",
     "shapes.floor.half_space.normal: found [0,0,0], expected a "
     "vector that is not zero"},
    {"shapes.s={\"mesh\":\"a.obj\",\"scale\":0}", "shapes.s.scale: found 0, expected a number above 0"},
    {"shapes.s={\"mesh\":\"a.obj\",\"scale\":[1,1,-1]}", "shapes.s.scale.2: found -1, expected"},
    {"shapes.s={\"mesh\":\"\"}", "shapes.s.mesh: found \"\", expected a name"},
    {"shapes.s={}", "shapes.s: found no kind of shape, expected one of"},
    {"shapes.s={\"box\":[1,1,1],\"sphere\":1}", "shapes.s: found \"box\" and \"sphere\", expected one"},
    {"bodies.1.orientation=[0,0,0,0]", "bodies.1.orientation: found [0,0,0,0], expected a quaternion"},
    {"bodies.1.position=[0,0,1e200]", "bodies.1.position.2: found 1e+200, expected a number"},
    {"bodies.1.name=\"a\\nb\"", "bodies.1.name: found \"a\\nb\", expected a name"},
    {"output.every=0", "output.every: found 0, expected a number above 0"},
    {"output.checkpoint_every=-1", "output.checkpoint_every: found -1, expected a number not below 0"},
    {"output.every=1e-12", "output.every: found more than 1e9 rows"},
    {"stepping.step=0", "stepping.step: found 0, expected a number above 0"},
    {"stepping.rtol=0", "stepping.rtol: found 0, expected a number above 0"},
    {"stepping.max_order=6", "stepping.max_order: found 6, expected a whole number from 1 to 5"},
    {"stepping.iterations=5", "stepping.iterations: found 5, expected it only with"},
    {"stepping.method=verlet", "stepping: found no fixed step, expected"},
    // Names that lead nowhere, or are used twice.
    {"bodies.1.shape=crat", "bodies.1.shape: found \"crat\", expected the name of a shape"},
    {"bodies.1.material=wood", "bodies.1.material: found \"wood\", expected the name of a material"},
    {"bodies.1.name=ground", "bodies.1: found the name \"ground\" again, expected a name of its own"},
    {"bodies.1.name=ball.0", "bodies.2: found the name \"ball.0\" again, expected a name of its own"},
    {"pairs=[{\"materials\":[\"rock\"]}]", "pairs.0.materials: found [\"rock\"], expected the names of two"},
    {"pairs=[{\"materials\":[\"rock\",\"ice\"]}]", "pairs.0.materials.1: found \"ice\", expected the name"},
    {"pairs=[{\"materials\":[\"rock\",\"rock\"]},{\"materials\":[\"rock\",\"rock\"]}]",
     "pairs.1.materials: found \"rock\" and \"rock\" again, expected one entry a pair"},
    {"bodies.0.motion=dynamic", "bodies.0.motion: found a half-space that is dynamic, expected \"fixed\""},
    {"bodies.0.velocity=[1,0,0]", "bodies.0.velocity: found a fixed body that moves, expected"},
    {"bodies=[]", "found no bodies, expected at least one"},
    // Fill.
    {"fill=[{\"shape\":\"ball\"}]", "fill.0: found no \"material\", expected that key"},
    {"fill=[{\"shape\":\"floor\",\"material\":\"rock\",\"count\":1,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.shape: found \"floor\", a half-space, expected a bounded shape"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":0,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.count: found 0, expected a whole number from 1 to 1000000"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1e9,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.count: found 1000000000.0, expected a whole number"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1000000,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill: found 1000003 bodies, expected 1000000 at most"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1,\"box\":[[0,0,0],[1,1,0]]}]",
     "fill.0.box: found [[0,0,0],[1,1,0]], expected the lowest corner, then the highest"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1,\"size\":[2,1],\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.size: found [2,1], expected the smaller number first"},
    {"fill=[{\"shape\":\"ball\",\"material\":\"rock\",\"count\":1,\"seed\":-1,\"box\":[[0,0,0],[1,1,1]]}]",
     "fill.0.seed: found -1, expected a whole number not below 0"},
    // Settings themselves.
    {"end_time", "--set \"end_time\": found no key and value, expected KEY=VALUE"},
    {"=3", "--set \"=3\": found no key and value, expected KEY=VALUE"},
    {"law..normal=3", "--set \"law..normal=3\": found an empty part of the path"},
    {"bodies.3.name=x", "--set \"bodies.3.name=x\": found \"3\", expected a number from 0 to 2"},
    {"end_time.unit=s", "--set \"end_time.unit=s\": found 0.1, expected an object or a list"},
    {"law={\"normal\":1,\"normal\":1}",
     "--set \"law={\\\"normal\\\":1,\\\"normal\\\":1}\": normal: found the key twice"},
};

const BadSetting absent_settings[] = {
    {"law.normal=energy", "law.normal: found \"energy\", which is not in this build"},
    {"law.normal=manifold", "law.normal: found \"manifold\", which is not in this build"},
    {"materials.rock.torsion=patch", "materials.rock.torsion: found \"patch\", which is not in this build"},
    {"materials.rock.cohesion=1", "materials.rock.cohesion: found 1, which is not in this build"},
    {"bodies.1.motion={\"velocity\":[1,0,0]}", "bodies.1.motion: found an object, which is not in this"},
    {"shapes.s={\"mesh\":\"a.obj\",\"parts\":\"decompose\"}",
     "shapes.s.parts: found \"decompose\", which is"},
    {"stepping.method=bullet", "stepping.method: found \"bullet\", which is not in this build"},
    {"output.replay=true", "output.replay: found true, which is not in this build"},
    {"stepping.solver=fixed_point", "stepping.solver: found \"fixed_point\", which is not in this build"},
    {"output.vtk=true", "output.vtk: found true, which is not in this build"},
    {"output.checkpoint_every=0.1", "output.checkpoint_every: found 0.1, which is not in this build"},
};

void check_refused(const std::string& message, const std::string& expected) {
    CHECK_THAT(message, Catch::Contains(expected));
    CHECK(std::count(message.begin(), message.end(), '\n') == 0);
    CHECK(message.size() < 300);
}

}  // namespace

TEST_CASE("Text that is no scene is refused by file and line or key", "[scenes]") {
    for (const BadText& bad : bad_texts) {
        CAPTURE(bad.text);
        check_refused(refusal(bad.text), bad.message);
    }
}

TEST_CASE("A bad value is refused by file and key, with what was found and expected", "[scenes]") {
    for (const BadSetting& bad : bad_settings) {
        CAPTURE(bad.setting);
        const std::string message = refusal(small_scene, {bad.setting});
        check_refused(message, bad.message);
        CHECK(message.substr(0, 5) == (std::string(bad.message).substr(0, 5) == "--set" ? "--set" : "small"));
    }
}

TEST_CASE("What this build cannot do is refused, and not when it is switched off", "[scenes]") {
    for (const BadSetting& absent : absent_settings) {
        CAPTURE(absent.setting);
        check_refused(refusal(small_scene, {absent.setting}), absent.message);
    }
    const std::vector<std::string> off = {"output.vtk=false", "output.replay=false",
                                          "output.checkpoint_every=0"};
    CHECK(refusal(small_scene, off).empty());
}

TEST_CASE("Hostile text is refused without harm", "[scenes]") {
    const std::string deep(1'000'000, '[');
    check_refused(refusal(deep), "nested 17 deep");
    const std::string long_key = "{\"" + std::string(1'000'000, 'k') + "\": 1}";
    check_refused(refusal(long_key), "found an unknown key");
    const std::string long_string = "{\"gravity\": \"" + std::string(1'000'000, 's') + "\"}";
    check_refused(refusal(long_string), "…, expected a list of 3 numbers");
}
