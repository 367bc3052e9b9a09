#pragma once

// First hits of several rays at once. This header is compiled for AVX2 too, so it must not contain
// or include anything that another file could also instantiate. Products and sums are not
// contracted, so rays have the same bits here as one by one.

namespace palpate::rays
{
/// Maximum number of rays in a batch.
constexpr int MostRays = 64;
/// Rays side by side.
constexpr int Lanes = 4;
constexpr int MostMaterials = 32;
/// As BrickLayout::Shift.
constexpr int BrickShift = 3;

/// See FieldMaterial, MaterialMap and BrickedChannel.
struct Material
{
  bool IsSimple;         ///< one condition, trilinear: the only kind that is solved here
  int Type;              ///< signed and unsigned char, signed and unsigned short, float, double
  const unsigned* Codes; ///< the block of each brick
  const void* Blocks;
  unsigned long Stride; ///< elements from block to block
  double Iso;
  double Sign; ///< 1: at least, -1: at most
};

/// See BrickLayout and BrickDirectory.
struct Field
{
  int Cells[3];        ///< along i, j, k
  double BrickColumns; ///< bricks along i, j
  double BrickRows;
  const unsigned char* Entries;  ///< eight bytes per brick: the word, then the leap
  const unsigned char* Surfaces; ///< base of the word offsets; at least one surface brick: a bit
                                 ///< for each cell, its materials, and the materials that fill it
  long long Wanted;              ///< materials
  Material Materials[MostMaterials];
};

enum class Outcome
{
  Missed,
  Surface,
  Unstarted, ///< left to RayTraversal
  Underway   ///< left to RayTraversal, starting at the batch's T and Cell
};

/// Rays in index coordinates, by coordinate, and their results. A multiple of Lanes is read:
/// elements after the last ray must be valid numbers.
struct Batch
{
  alignas(32) double Origin[3][MostRays];
  alignas(32) double Direction[3][MostRays];
  alignas(32) double TMin[MostRays];
  alignas(32) double TMax[MostRays];

  Outcome Answer[MostRays];
  unsigned StartsInside[MostRays];
  double T[MostRays];
  int Cell[MostRays][3];
  double Gradient[MostRays][3]; ///< per voxel
  int Material[MostRays];
  bool IsEntering[MostRays];
};

/// Casts the first `count` rays of a batch. For AVX2; two lanes, as in SSE2 and NEON, are no faster
/// than single rays.
void CastAvx2(const Field& field, int count, Batch& batch);
} // namespace palpate::rays
