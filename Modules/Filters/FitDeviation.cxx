#include "FitDeviation.h"

#include "SphericalHarmonicBasis.h"
#include "SphericalHarmonicConventions.h"

#include "vtkSMPTools.h"

#include <algorithm>

namespace palpate
{
vtkSmartPointer<vtkDoubleArray> FitDeviation(const Eigen::MatrixXd& factor,
                                             const std::vector<Vector3>& directions,
                                             const char* name)
{
  const SphericalHarmonicBasis basis(DegreeOfCount(static_cast<std::size_t>(factor.rows())));
  auto deviations = vtkSmartPointer<vtkDoubleArray>::New();
  deviations->SetName(name);
  deviations->SetNumberOfTuples(static_cast<vtkIdType>(directions.size()));
  // sqrt(y^T F F^T y), in blocks: one matrix product per block.
  constexpr vtkIdType Block = 256;
  vtkSMPTools::For(
      0, static_cast<vtkIdType>(directions.size()), Block,
      [&](vtkIdType first, vtkIdType last)
      {
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> harmonics(
            last - first, factor.rows());
        for (vtkIdType id = first; id < last; ++id)
        {
          basis.Evaluate(directions[static_cast<std::size_t>(id)],
                         harmonics.row(id - first).data());
        }
        const Eigen::VectorXd lengths = (harmonics * factor).rowwise().norm();
        std::copy(lengths.begin(), lengths.end(), deviations->GetPointer(first));
      });
  return deviations;
}
} // namespace palpate
