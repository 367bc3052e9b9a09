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
  // sqrt(y^T F F^T y), in blocks: one matrix product per block, in single precision, since a
  // standard deviation needs no more than six digits. Without a penalty F is a triangle.
  constexpr vtkIdType Block = 256;
  using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const double scale = factor.cwiseAbs().maxCoeff() + 1e-300;
  const Eigen::MatrixXf scaled = (factor / scale).cast<float>();
  const bool isTriangle = scaled.isUpperTriangular(0.0F);
  vtkSMPTools::For(0, static_cast<vtkIdType>(directions.size()), Block,
                   [&](vtkIdType first, vtkIdType last)
                   {
                     Rows harmonics(last - first, factor.rows());
                     Eigen::VectorXd values(factor.rows());
                     for (vtkIdType id = first; id < last; ++id)
                     {
                       basis.Evaluate(directions[static_cast<std::size_t>(id)], values.data());
                       harmonics.row(id - first) = values.cast<float>();
                     }
                     const Rows products =
                         isTriangle ? Rows(harmonics * scaled.triangularView<Eigen::Upper>())
                                    : Rows(harmonics * scaled);
                     const Eigen::VectorXd lengths =
                         scale * products.cast<double>().rowwise().norm();
                     std::copy(lengths.begin(), lengths.end(), deviations->GetPointer(first));
                   });
  return deviations;
}
} // namespace palpate
