#pragma once

#include "Covariates.h"
#include "ModelFormula.h"
#include "Status.h"

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

namespace palpate
{
/// Columns of a term of a formula in a design.
struct DesignTerm
{
  std::string Name;
  Eigen::Index First = 0;
  Eigen::Index Count = 0;
  /// False for a part of an interaction, whose own effect depends on how factors are coded.
  bool IsTested = true;
  bool IsInteraction = false;
  bool IsNumeric = false; ///< one column of numbers, whose effect is per unit
  double Deviation = 0.0; ///< standard deviation of that column
};

/// The matrix of a linear model. Factors are coded by treatment contrasts: one column for each
/// level but the reference. Names are R's: (Intercept), age, groupB, age:groupB.
struct LinearDesign
{
  Eigen::MatrixXd Matrix; ///< one row per kept case, one column per coefficient; of full rank
  std::vector<std::string> Columns;
  std::vector<DesignTerm> Terms;
  std::vector<std::size_t> Cases;                ///< kept rows of the table
  std::vector<std::size_t> Omitted;              ///< other rows, which lack a value
  std::vector<std::string> Lacking;              ///< the columns that these lack
  std::map<std::string, std::string> References; ///< of each factor

  /// "2 of 40 cases lack a value of psa and are omitted"; empty if none is.
  std::string OmissionText() const;
};

/// Reads "COLUMN=LEVEL" texts; of two for one column the last counts. Fails for any other text.
Status ParseReferences(const std::vector<std::string>& texts,
                       std::map<std::string, std::string>& references);

/// Makes the design of a formula. `references` has the reference level of factors (columns), whose
/// default is the first one in the order of their bytes. Cases that lack a value of a used column
/// or of a `needed` one are omitted. Fails, with a sentence that names what is wrong, if a column
/// is unknown, a category is used as a number or has as many levels as cases, a factor has one
/// level, a logarithm or root is not defined, an interaction lacks its parts, a column of the
/// matrix is a combination of those before it, or the kept cases are no more than the columns.
Status MakeLinearDesign(const CovariateTable& table, const ModelFormula& formula,
                        const std::map<std::string, std::string>& references, LinearDesign& design,
                        const std::vector<std::string>& needed = {});

/// The design with further columns, one per column of `values`, a row per kept case. They belong to
/// no term, so all terms are tested given them.
LinearDesign WithColumns(LinearDesign design, const Eigen::MatrixXd& values,
                         const std::vector<std::string>& names);
} // namespace palpate
