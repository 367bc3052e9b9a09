#include "RepeatedScans.h"

#include "CsvText.h"
#include "DecimalText.h"
#include "InputError.h"
#include "WholeFile.h"

#include <algorithm>
#include <vector>

namespace palpate
{
namespace
{
constexpr Eigen::Index MostRepeatedModes = 10;

std::string RepeatedTable(const CohortGroup& group, const CovariateTable& covariates,
                          Eigen::Index modes)
{
  std::vector<std::string> head = ModeNames(modes);
  head.insert(head.begin(), "case");
  for (const Covariate& column : covariates.Columns())
  {
    head.push_back(column.Name());
  }
  std::string text = CsvLine(head);
  for (std::size_t row = 0; row < group.Rows.size(); ++row)
  {
    std::vector<std::string> fields{group.Rows[row].Case};
    for (Eigen::Index k = 0; k < modes; ++k)
    {
      fields.push_back(ExactText(group.Modes.Scores(static_cast<Eigen::Index>(row), k)));
    }
    for (const Covariate& column : covariates.Columns())
    {
      fields.push_back(column.IsMissing(row) ? std::string() : column.Texts()[row]);
    }
    text += CsvLine(fields);
  }
  return text;
}
// What of the script depends on nothing. The cases of a patient are decorrelated by taking a part
// of their mean away, so that each fit is one of least squares.
constexpr const char* const MixedModel = R"(
stopifnot("no patient has several scans" = max(tabulate(patient)) > 1)
counts <- tabulate(patient)
n <- nrow(x)
p <- ncol(x)

patient_means <- function(v) {
  (rowsum(v, patient) / counts)[patient, , drop = FALSE]
}
# Values whose residuals are independent, if the intercepts have `ratio` times the residuals' variance.
whiten <- function(v, ratio) {
  v - (1 - 1 / sqrt(1 + counts[patient] * ratio)) * patient_means(v)
}
# Twice the negative logarithm of the restricted likelihood, but for a constant.
deviance_of <- function(ratio, y) {
  q <- qr(whiten(x, ratio))
  (n - p) * log(sum(qr.resid(q, whiten(y, ratio))^2)) + sum(log(1 + counts * ratio)) +
    2 * sum(log(abs(diag(qr.R(q)))))
}
best_ratio <- function(y) {
  inner <- optimize(function(l) deviance_of(exp(l), y), c(-15, 15), tol = 1e-10)
  if (deviance_of(0, y) <= inner$objective) 0 else exp(inner$minimum)
}

# Degrees of freedom: of the patients for what is the same in all scans of each, otherwise of the scans.
varies <- colSums((x - patient_means(x))^2) > 1e-12 * colSums(x^2)
free <- ifelse(varies, n - length(counts) - sum(varies), length(counts) - sum(!varies))
terms <- attr(x, "assign")

for (k in seq_len(modes)) {
  y <- matrix(d[[paste0("mode_", k)]]) # mm
  ratio <- best_ratio(y)
  q <- qr(whiten(x, ratio))
  variance <- sum(qr.resid(q, whiten(y, ratio))^2) / (n - p)
  covariance <- variance * chol2inv(qr.R(q))
  b <- drop(qr.coef(q, whiten(y, ratio)))
  se <- sqrt(diag(covariance))
  cat("\nMode", k, "- standard deviation, mm: between patients", sqrt(ratio * variance), "within", sqrt(variance), "\n")
  for (term in setdiff(unique(terms), 0)) {
    i <- which(terms == term)
    f <- drop(b[i] %*% solve(covariance[i, i], b[i])) / length(i)
    cat(names[term], ": F", f, "with", length(i), "and", min(free[i]), "degrees of freedom, p",
        pf(f, length(i), min(free[i]), lower.tail = FALSE), "\n")
  }
  print(cbind(mm = b, se = se, df = free, t = b / se, p = 2 * pt(-abs(b / se), free)))
}
)";
} // namespace

void WriteRepeatedScans(const CohortGroup& group, const CovariateTable& covariates,
                        const ModelFormula& formula, const std::string& patient,
                        const std::filesystem::path& folder)
{
  if (covariates.Find(patient) == nullptr)
  {
    throw InputError("the covariates have no column " + patient + " that names the patients");
  }
  const Eigen::Index modes = std::min(MostRepeatedModes, group.Modes.Scores.cols());
  FormulaVariable column;
  column.Column = patient;
  const std::string named = "d$" + column.Text();
  WriteWholeFile(folder / "repeated.csv", RepeatedTable(group, covariates, modes));
  WriteWholeFile(folder / "repeated.R",
                 "# Shapes of patients who were scanned more than once: a random intercept for "
                 "each patient, by\n"
                 "# restricted maximum likelihood. Run in this folder: Rscript repeated.R. R alone "
                 "is enough.\n"
                 "d <- read.csv(\"repeated.csv\", stringsAsFactors = TRUE, check.names = FALSE, "
                 "na.strings = c(\"NA\", \"\"))\n"
                 "model <- " +
                     formula.Text() +
                     "\n"
                     "d <- d[complete.cases(model.frame(model, d, na.action = na.pass)) & !is.na(" +
                     named +
                     "), ]\n"
                     "d <- droplevels(d)\n"
                     "patient <- as.integer(factor(" +
                     named +
                     "))\n"
                     "x <- model.matrix(model, d)\n"
                     "names <- attr(terms(model), \"term.labels\")\n"
                     "modes <- " +
                     std::to_string(modes) + "\n" + MixedModel);
}
} // namespace palpate
