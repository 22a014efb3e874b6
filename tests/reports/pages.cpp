#include <catch2/catch.hpp>

#include <src/reports/comparison.hpp>
#include <src/reports/page.hpp>

using namespace scree;

namespace {

Work work(bool by_bullet, double seconds, double error) {
    Work each;
    each.by_bullet = by_bullet;
    each.seconds = seconds;
    each.error = error;
    return each;
}

}  // namespace

TEST_CASE("A page says the same in HTML and in Markdown, and escapes what it is given", "[reports]") {
    Page page;
    page.heading(2, "Cost & more").text("a < b").table({{"x|y", "z"}, {"failed 3", "<b>"}});
    page.picture("a.svg", "A picture");
    const std::string html = page.html("title");
    CHECK_THAT(html, Catch::Contains("<h2>Cost &amp; more</h2>") && Catch::Contains("a &lt; b"));
    CHECK_THAT(html, Catch::Contains("<td class=\"failed\">failed 3</td><td>&lt;b&gt;</td>"));
    CHECK_THAT(html, Catch::Contains("<img src=\"a.svg\" alt=\"A picture\">"));
    const std::string text = page.markdown();
    CHECK_THAT(
        text, Catch::StartsWith("## Cost & more\n\na < b\n\n| x\\|y | z |\n|---|---|\n| failed 3 | <b> |\n"));
    CHECK_THAT(text, Catch::EndsWith("![A picture](a.svg)\n"));
}

TEST_CASE("A row of Bullet's is beaten by one that takes no longer to no larger an error", "[reports]") {
    std::vector<Work> all = {work(true, 1, 1e-2), work(true, 0.1, 1), work(false, 0.5, 1e-3)};
    Standing stands = standing(all);
    CHECK(stands.bullet_rows == 2);
    CHECK(stands.beaten == 1);
    CHECK(stands.best_beaten);
    CHECK_THAT(stands.verdict, Catch::StartsWith("ahead of Bullet's most exact"));
    all.push_back(work(false, 0.1, 1));
    CHECK(standing(all).verdict == "ahead without exception");
    all.push_back(work(true, 0.4, 1e-6));
    stands = standing(all);
    CHECK(stands.verdict == "behind Bullet's most exact");
    CHECK(most_exact(all, false, 0.2)->error == 1);
    CHECK(fastest(all, false, 1e-2)->seconds == 0.5);
    CHECK(fastest(all, false, 1e-9) == nullptr);
    CHECK(standing({work(false, 1, 1)}).verdict == "Bullet has no answer");
}
