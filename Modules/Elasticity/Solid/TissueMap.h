#pragma once

#include "FieldGrid.h"
#include "Status.h"
#include "Vector3.h"

#include <memory>
#include <vector>

namespace palpate
{
/// Young's modulus at every point of an organ: that of its tissue, of inclusions one over the
/// other, and of an elastography image. Immutable once built; queries are const and thread-safe.
class TissueMap
{
public:
  /// Values at the nodes of a grid: i fastest.
  struct Samples
  {
    FieldGrid Grid;
    std::vector<float> Values;

    /// Trilinear; 0 outside of the grid.
    double At(const Vector3& pointWorld) const noexcept;
  };

  static constexpr double LeastModulus = 1e-6; ///< N/mm^2
  static constexpr double MostModulus = 1e3;   ///< N/mm^2
  static constexpr double MostExaggeration = 5.0;

  /// `modulus` is that of the organ's tissue, N/mm^2. A map with a modulus outside the limits
  /// fails when it is checked.
  explicit TissueMap(double modulus) : Tissue(modulus) {}

  /// Where `fraction` is 1, `modulus` (N/mm^2) counts instead of what was added before; between 0
  /// and 1 in part (Voigt's mean), outside of the grid not at all.
  void AddInclusion(std::shared_ptr<const Samples> fraction, double modulus);
  /// The image's values (N/mm^2) count instead of what was added before, inside of its grid; voxels
  /// of values outside the limits, such as 0 around an organ, stand for what was added before.
  void AddImage(std::shared_ptr<const Samples> moduli);

  /// Raises the contrast of every place with the tissue to a power, from 1 (none) to
  /// MostExaggeration: at 2, three times as stiff becomes nine times. Within the limits of moduli.
  void Exaggerate(double power) { this->Power = power; }

  /// Fails for a modulus outside the limits and for samples that do not fit their grid.
  Status Check() const;

  /// Of the organ's tissue, N/mm^2.
  double OwnModulus() const noexcept { return this->Tissue; }
  /// N/mm^2.
  double Modulus(const Vector3& pointWorld) const noexcept;

private:
  struct Layer
  {
    std::shared_ptr<const Samples> Image;
    bool IsFraction;
    double Modulus; // N/mm^2, of an inclusion
  };

  double Tissue; // N/mm^2
  double Power = 1.0;
  std::vector<Layer> Layers;
};
} // namespace palpate
