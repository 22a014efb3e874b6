#include <cmath>
#include <fstream>
#include <limits>

#include <catch2/catch.hpp>

#include <src/reports/table.hpp>
#include <tests/cli/child.hpp>

using namespace scree;
using scree::test::Folder;
using scree::test::text_of;

namespace {

const Row columns = {"case", "step", "error"};

Table table_in(const Folder& folder) {
    return {folder / "table.csv", columns, {"case", "step"}};
}

}  // namespace

TEST_CASE("A line of a table is read as it was written", "[reports]") {
    const Row row = {"plain", "with, comma", "with \"quotes\"", "two\nlines", "", "µ"};
    CHECK(csv_rows(csv_line(row) + "\n") == std::vector<Row>{row});
    CHECK(csv_rows("a,b\nc,d\n") == std::vector<Row>{{"a", "b"}, {"c", "d"}});
    CHECK(csv_rows("a,b\nhalf a ro") == std::vector<Row>{{"a", "b"}});
    CHECK(csv_rows("").empty());
}

TEST_CASE("Numbers in cells keep six digits, and what is no number is empty", "[reports]") {
    CHECK(cell(0.1) == "0.1");
    CHECK(cell(1.0 / 240) == "0.00416667");
    CHECK(cell(std::numeric_limits<double>::infinity()).empty());
    CHECK(cell(std::numeric_limits<double>::quiet_NaN()).empty());
    CHECK(number_in("1e-3") == 1e-3);
    CHECK(std::isnan(number_in("")));
    CHECK(std::isnan(number_in("adaptive")));
}

TEST_CASE("A table grows on disk row by row, and is gone on with", "[reports]") {
    const Folder folder;
    {
        Table table = table_in(folder);
        CHECK(table.rows().empty());
        CHECK_FALSE(std::filesystem::exists(folder / "table.csv"));
        table.add({"incline", "0.1", "3"});
        CHECK(text_of(folder / "table.csv") == "case,step,error\nincline,0.1,3\n");
        table.add({"incline", "0.2", "4"});
    }
    std::ofstream(folder / "table.csv", std::ios::app) << "incline,0.3";
    Table table = table_in(folder);
    CHECK(table.rows().size() == 2);
    CHECK(table.has({"incline", "0.2"}));
    CHECK_FALSE(table.has({"incline", "0.3"}));
    CHECK(text_of(folder / "table.csv") == "case,step,error\nincline,0.1,3\nincline,0.2,4\n");
    CHECK(table.number(table.rows()[1], "error") == 4);
    CHECK_THROWS(table.add({"too", "few"}));
}

TEST_CASE("A table of other columns is not gone on with", "[reports]") {
    const Folder folder;
    std::ofstream(folder / "table.csv") << "case,error\nincline,1\n";
    CHECK(table_in(folder).rows().empty());
    CHECK(text_of(folder / "table.csv") == "case,step,error\n");
}
