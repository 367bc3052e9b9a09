#pragma once

// Kernels of PackedTriangle. This header is compiled once per instruction set, with different
// options, so it must not contain or include anything that another file could also instantiate; see
// Quartet.h.

namespace palpate::triangle
{
/// Functions of one instruction set for lower triangles L in strips of `Lanes` rows: strip s holds
/// the columns 0 .. Lanes (s + 1) - 1, each as `Lanes` consecutive numbers, and strips are
/// contiguous. Vectors have Lanes numbers per strip and are aligned to a cache line.
struct Kernel
{
  int Lanes;
  /// Cholesky factorisation in place; `reciprocals` receives the inverse of the diagonal. Returns
  /// false if a pivot is not above `smallest` times the former diagonal entry.
  bool (*Factorise)(double* strips, int count, double smallest, double* reciprocals);
  /// x := L^-1 x and x := L^-T x.
  void (*SolveLower)(const double* strips, int count, const double* reciprocals, double* x);
  void (*SolveUpper)(const double* strips, int count, const double* reciprocals, double* x);
  /// y := L x and y := L^T x.
  void (*MultiplyLower)(const double* strips, int count, const double* x, double* y);
  void (*MultiplyUpper)(const double* strips, int count, const double* x, double* y);
};

/// `Set` describes an instruction set: `Vector`, a vector of doubles (GCC and Clang's vector
/// extension), and `Lanes`, how many it holds.
template <typename Set>
struct Arithmetic
{
  using Vector = typename Set::Vector;
  static constexpr int W = Set::Lanes;

  static inline __attribute__((always_inline)) Vector* At(double* strips, int strip)
  {
    return reinterpret_cast<Vector*>(strips) + static_cast<long>(W) * strip * (strip + 1) / 2;
  }
  static inline __attribute__((always_inline)) const Vector* At(const double* strips, int strip)
  {
    return reinterpret_cast<const Vector*>(strips) + static_cast<long>(W) * strip * (strip + 1) / 2;
  }
  static inline __attribute__((always_inline)) double Sum(const Vector& v)
  {
    double sum = v[0] + v[1];
    for (int lane = 2; lane < W; lane += 2)
    {
      sum += v[lane] + v[lane + 1];
    }
    return sum;
  }

  // Subtracts from some strips, in the columns of strip `block`, the product of the part to the
  // left.
  template <int Strips>
  static inline __attribute__((always_inline)) void Update(double* strips, int first, int block,
                                                           Vector (&sums)[Strips][W])
  {
    const double* factors = reinterpret_cast<const double*>(At(strips, block));
    const Vector* rows[Strips];
    for (int s = 0; s < Strips; ++s)
    {
      rows[s] = At(strips, first + s);
      for (int c = 0; c < W; ++c)
      {
        sums[s][c] = rows[s][block * W + c];
      }
    }
    for (int k = 0; k < block * W; ++k)
    {
      for (int c = 0; c < W; ++c)
      {
        const double factor = factors[k * W + c];
        for (int s = 0; s < Strips; ++s)
        {
          sums[s][c] -= factor * rows[s][k];
        }
      }
    }
  }

  // The strips below the block on the diagonal: X := X L^-T of that block.
  template <int Strips>
  static inline __attribute__((always_inline)) void Below(double* strips, int first, int block,
                                                          const double* reciprocals)
  {
    Vector sums[Strips][W];
    Update<Strips>(strips, first, block, sums);
    const Vector* diagonal = At(strips, block) + block * W;
    for (int c = 0; c < W; ++c)
    {
      for (int s = 0; s < Strips; ++s)
      {
        Vector sum = sums[s][c];
        for (int d = 0; d < c; ++d)
        {
          sum -= diagonal[d][c] * sums[s][d];
        }
        sums[s][c] = sum * reciprocals[block * W + c];
      }
    }
    for (int s = 0; s < Strips; ++s)
    {
      Vector* row = At(strips, first + s) + block * W;
      for (int c = 0; c < W; ++c)
      {
        row[c] = sums[s][c];
      }
    }
  }

  static bool FactoriseDiagonal(double* strips, int block, double smallest, double* reciprocals)
  {
    Vector sums[1][W];
    Vector* diagonal = At(strips, block) + block * W;
    Update<1>(strips, block, block, sums);
    for (int c = 0; c < W; ++c)
    {
      const double before = diagonal[c][c];
      for (int d = 0; d < c; ++d)
      {
        sums[0][c] -= sums[0][d][c] * sums[0][d];
      }
      const double pivot = sums[0][c][c];
      if (!(pivot > smallest * before) || !(before > 0.0))
      {
        return false;
      }
      const double root = __builtin_sqrt(pivot);
      reciprocals[block * W + c] = 1.0 / root;
      sums[0][c] = sums[0][c] * reciprocals[block * W + c];
      for (int row = 0; row < c; ++row)
      {
        sums[0][c][row] = 0.0;
      }
      sums[0][c][c] = root;
      diagonal[c] = sums[0][c];
    }
    return true;
  }

  static bool Factorise(double* strips, int count, double smallest, double* reciprocals)
  {
    for (int block = 0; block < count; ++block)
    {
      if (!FactoriseDiagonal(strips, block, smallest, reciprocals))
      {
        return false;
      }
      int first = block + 1;
      for (; first + 3 <= count; first += 3)
      {
        Below<3>(strips, first, block, reciprocals);
      }
      for (; first < count; ++first)
      {
        Below<1>(strips, first, block, reciprocals);
      }
    }
    return true;
  }

  // sum_k row[k] x[k] for k < count, in several chains to hide latency; count is a multiple of W.
  static inline __attribute__((always_inline)) Vector RowProduct(const Vector* row, int count,
                                                                 const double* x)
  {
    Vector sums[W];
    for (int c = 0; c < W; ++c)
    {
      sums[c] = Vector{};
    }
    for (int k = 0; k < count; k += W)
    {
      for (int c = 0; c < W; ++c)
      {
        sums[c] += row[k + c] * x[k + c];
      }
    }
    Vector sum = sums[0] + sums[1];
    for (int c = 2; c < W; c += 2)
    {
      sum += sums[c] + sums[c + 1];
    }
    return sum;
  }

  // sum_s of the strips starting at `first`, in the columns of `block`, times x: one number per
  // column.
  static inline __attribute__((always_inline)) Vector
  ColumnProduct(const double* strips, int first, int count, int block, const Vector* x)
  {
    Vector sums[W];
    for (int c = 0; c < W; ++c)
    {
      sums[c] = Vector{};
    }
    for (int s = first; s < count; ++s)
    {
      const Vector* row = At(strips, s) + block * W;
      for (int c = 0; c < W; ++c)
      {
        sums[c] += row[c] * x[s];
      }
    }
    Vector result{};
    for (int c = 0; c < W; ++c)
    {
      result[c] = Sum(sums[c]);
    }
    return result;
  }

  static void SolveLower(const double* strips, int count, const double* reciprocals, double* x)
  {
    auto* vectors = reinterpret_cast<Vector*>(x);
    for (int s = 0; s < count; ++s)
    {
      const Vector* row = At(strips, s);
      Vector rest = vectors[s] - RowProduct(row, s * W, x);
      for (int c = 0; c < W; ++c)
      {
        const double value = rest[c] * reciprocals[s * W + c];
        rest -= value * row[s * W + c]; // zeros above the diagonal leave earlier lanes unchanged
        rest[c] = value;
      }
      vectors[s] = rest;
    }
  }

  static void SolveUpper(const double* strips, int count, const double* reciprocals, double* x)
  {
    auto* vectors = reinterpret_cast<Vector*>(x);
    for (int s = count - 1; s >= 0; --s)
    {
      const Vector* diagonal = At(strips, s) + s * W;
      Vector rest = vectors[s] - ColumnProduct(strips, s + 1, count, s, vectors);
      for (int c = W - 1; c >= 0; --c)
      {
        double value = rest[c];
        for (int r = c + 1; r < W; ++r)
        {
          value -= diagonal[c][r] * rest[r];
        }
        rest[c] = value * reciprocals[s * W + c];
      }
      vectors[s] = rest;
    }
  }

  static void MultiplyLower(const double* strips, int count, const double* x, double* y)
  {
    for (int s = 0; s < count; ++s)
    {
      reinterpret_cast<Vector*>(y)[s] = RowProduct(At(strips, s), (s + 1) * W, x);
    }
  }

  static void MultiplyUpper(const double* strips, int count, const double* x, double* y)
  {
    for (int s = 0; s < count; ++s)
    {
      reinterpret_cast<Vector*>(y)[s] =
          ColumnProduct(strips, s, count, s, reinterpret_cast<const Vector*>(x));
    }
  }
};

/// Portable: two lanes are SSE2 on x86-64 and NEON on arm64.
extern const Kernel Portable;
/// For x86-64 with AVX2 and FMA.
extern const Kernel Avx2;
} // namespace palpate::triangle
