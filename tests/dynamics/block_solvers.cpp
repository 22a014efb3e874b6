// The incomplete factorisation and the choice of the linear solver.

#include <catch2/catch.hpp>
#include <scree/dynamics/linear_solver.hpp>

#include <tests/support/random.hpp>

using namespace scree;
using namespace scree::test;

namespace {

Mat6 random_block(Random& random) {
    return Mat6::NullaryExpr([&]() { return random.uniform(-1, 1); });
}

Eigen::VectorXd random_vector(Random& random, int blocks) {
    return Eigen::VectorXd::NullaryExpr(6 * blocks, [&]() { return random.uniform(-1, 1); });
}

// `coupling` between the pairs, and a diagonal of size one.
BlockMatrix matrix_of(Random& random, int size, const std::vector<std::pair<int, int>>& pairs,
                      double coupling) {
    BlockMatrix matrix;
    matrix.clear(size);
    for (int i = 0; i < size; ++i) {
        matrix.add(i, i, Mat6::Identity() + 0.1 * random_block(random));
    }
    for (const auto& [a, b] : pairs) {
        matrix.add(a, b, coupling * random_block(random));
        matrix.add(b, a, coupling * random_block(random));
    }
    matrix.finish();
    return matrix;
}

std::vector<std::pair<int, int>> chain(int size) {
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i + 1 < size; ++i) {
        pairs.emplace_back(i, i + 1);
    }
    return pairs;
}

// Every body with many others, as no order eliminates without fill.
std::vector<std::pair<int, int>> tangle(Random& random, int size) {
    std::vector<std::pair<int, int>> pairs;
    for (int i = 0; i < size; ++i) {
        for (int j = i + 1; j < size; ++j) {
            if (random.uniform(0, 1) < 0.2) {
                pairs.emplace_back(i, j);
            }
        }
    }
    return pairs;
}

Eigen::VectorXd product(const BlockMatrix& matrix, const Eigen::VectorXd& x) {
    Eigen::SparseMatrix<double> scalars;
    matrix.expand(scalars);
    return scalars * x;
}

}  // namespace

TEST_CASE("A block matrix sums what is added at one place and expands to the same scalars", "[dynamics]") {
    Random random(301);
    const Mat6 first = random_block(random);
    const Mat6 second = random_block(random);
    const Mat6 diagonal = random_block(random);
    BlockMatrix matrix;
    matrix.clear(3);
    matrix.add(2, 0, first);
    matrix.add(0, 2, second);
    matrix.add(2, 0, second);
    matrix.add(1, 1, diagonal);
    matrix.finish();
    Eigen::SparseMatrix<double> scalars;
    matrix.expand(scalars);
    Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(18, 18);
    expected.block<6, 6>(12, 0) = first + second;
    expected.block<6, 6>(0, 12) = second;
    expected.block<6, 6>(6, 6) = diagonal;
    CHECK((scalars.toDense() - expected).norm() == 0);
}

TEST_CASE("The incomplete factorisation of a chain is complete", "[dynamics]") {
    Random random(302);
    const BlockMatrix matrix = matrix_of(random, 30, chain(30), 0.5);
    BlockIncompleteLU factors;
    REQUIRE(factors.eliminate(matrix));
    const Eigen::VectorXd right = random_vector(random, 30);
    CHECK((product(matrix, factors.solve(right)) - right).norm() < 1e-10 * right.norm());
}

TEST_CASE("The incomplete factorisation leaves out what fills in, and says when a pivot is singular",
          "[dynamics]") {
    Random random(303);
    const BlockMatrix matrix = matrix_of(random, 30, tangle(random, 30), 0.02);
    BlockIncompleteLU factors;
    REQUIRE(factors.eliminate(matrix));
    const Eigen::VectorXd right = random_vector(random, 30);
    const double left = (product(matrix, factors.solve(right)) - right).norm() / right.norm();
    CHECK(left < 0.1);
    CHECK(left > 1e-6);

    BlockMatrix singular;
    singular.clear(2);
    singular.add(0, 0, Mat6::Zero());
    singular.add(1, 1, Mat6::Identity());
    singular.finish();
    CHECK_FALSE(factors.eliminate(singular));
}

TEST_CASE("Whatever the coupling, a matrix is solved: by iteration where that converges", "[dynamics]") {
    Random random(304);
    for (const int size : {1, 8, 9, 40}) {
        for (const double coupling : {0.01, 0.1, 1.0, 30.0}) {
            CAPTURE(size, coupling);
            const BlockMatrix matrix = matrix_of(random, size, tangle(random, size), coupling);
            LinearSolver solver;
            REQUIRE(solver.prepare(matrix));
            const Eigen::VectorXd right = random_vector(random, size);
            Eigen::VectorXd x = right;
            REQUIRE(solver.solve(x));
            CHECK((product(matrix, x) - right).norm() < 2e-6 * right.norm());
            x = right;
            REQUIRE(solver.solve(x));
            CHECK((product(matrix, x) - right).norm() < 2e-6 * right.norm());
        }
    }
}
