#pragma once

#include "Covariates.h"
#include "DecimalText.h"
#include "TemporaryFolder.h"

#include <Eigen/Core>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace palpate::test
{
/// R as a judge: an independent implementation that these tests run as a program of its own.
class RProgram
{
public:
  static bool IsThere() { return std::system("Rscript --version >/dev/null 2>&1") == 0; } // NOLINT

  /// Runs a script that finds the covariates in the data frame `d`, the outcomes in the matrix `y`,
  /// and gives numbers to `out(…)`. The numbers, in order; none if R fails.
  std::vector<double> Run(const CovariateTable& table, const Eigen::MatrixXd& outcomes,
                          const std::string& script) const
  {
    this->WriteCovariates(table);
    this->WriteOutcomes(outcomes);
    std::ofstream(this->Folder / "judge.R")
        << "d <- read.csv('d.csv', stringsAsFactors = TRUE)\n"
        << "y <- as.matrix(read.csv('y.csv', header = FALSE))\n"
        << "out <- function(x) cat(sprintf('%.17g\\n', as.vector(x)), file = 'out', append = TRUE, "
           "sep = '')\n"
        << script << '\n';
    const std::string command =
        "cd '" + this->Folder.Path().string() + "' && Rscript --vanilla judge.R >log 2>&1";
    std::vector<double> numbers;
    if (std::system(command.c_str()) == 0) // NOLINT: a fixed text
    {
      std::istringstream text(ReadAll(this->Folder / "out"));
      for (std::string word; text >> word;)
      {
        numbers.push_back(ParseNumber(word).value_or(0.0));
      }
    }
    return numbers;
  }
  std::string Log() const { return ReadAll(this->Folder / "log"); }

private:
  void WriteCovariates(const CovariateTable& table) const
  {
    std::ofstream file(this->Folder / "d.csv");
    for (std::size_t k = 0; k < table.Columns().size(); ++k)
    {
      file << (k == 0 ? "" : ",") << table.Columns()[k].Name();
    }
    for (std::size_t row = 0; row < table.Cases().size(); ++row)
    {
      file << '\n';
      for (std::size_t k = 0; k < table.Columns().size(); ++k)
      {
        file << (k == 0 ? "" : ",") << table.Columns()[k].Texts()[row];
      }
    }
    file << '\n';
  }
  void WriteOutcomes(const Eigen::MatrixXd& outcomes) const
  {
    std::ofstream file(this->Folder / "y.csv");
    for (Eigen::Index row = 0; row < outcomes.rows(); ++row)
    {
      for (Eigen::Index k = 0; k < outcomes.cols(); ++k)
      {
        file << (k == 0 ? "" : ",") << ExactText(outcomes(row, k));
      }
      file << '\n';
    }
  }

  TemporaryFolder Folder;
};
} // namespace palpate::test
