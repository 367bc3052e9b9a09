#pragma once

namespace palpate
{
/// The values by which Palpate's model files (JSON and CSV) state their convention. A reader
/// accepts only these, so that no file is read in a convention other than its own.
struct ModelConvention
{
  static constexpr const char* Format = "palpate spherical-harmonic model";
  static constexpr int Version = 2;
  static constexpr const char* Radial = "radial";
  static constexpr const char* Surface = "surface";
  static constexpr const char* Basis = "real spherical harmonics";
  static constexpr const char* Normalization = "orthonormal over the unit sphere";
  static constexpr const char* Phase = "no Condon-Shortley phase";
  static constexpr const char* PolarAxis = "+z";
  static constexpr const char* Order = "l(l+1)+m";
  static constexpr const char* Signs = "m >= 0: cos(m phi), m < 0: sin(|m| phi)";
  static constexpr const char* Frame = "patient LPS";
  static constexpr const char* Unit = "mm";

  /// Larger degrees are refused: no use is known, and a damaged file must not allocate gigabytes.
  static constexpr int MaximumDegree = 1000;
};
} // namespace palpate
