#pragma once

// Kernels of SampleMoments and ResidualMoments. This header is compiled once per instruction set,
// with different options, so it must not contain or include anything that another file could also
// instantiate; see Quartet.h.

namespace palpate::moments
{
/// Samples are processed in chunks of this size, in a buffer that fits the L1 cache. Sums over a
/// chunk are added to the total at its end, which also reduces rounding.
constexpr int ChunkPoints = 32;
/// Number of consecutive orders that share one family of polynomials in z, see MomentTables.
constexpr int OrdersPerFamily = 4;

/// Recurrence of the families: p_k = 2 z p_(k-1) - Factors[family * Stride + k] p_(k-2), p_0 = 1.
struct Recurrence
{
  const double* Factors;
  int Stride;
};

/// Samples: x, y, z of one unit vector after the other, weights and values.
struct Points
{
  const double* Directions;
  const double* Weights;
  const double* Values;
  long Count;
};

// The functions below are static, so that each file has its own copies.

/// Index of moment (order, column = 0) of moments up to `degree`; a moment is a pair.
static constexpr int MomentStart(int degree, int order)
{
  return order * (degree + 1) - order * (order - 1) / 2;
}
static constexpr int MomentCount(int degree)
{
  return MomentStart(degree, degree + 1);
}
/// Doubles of scratch memory for a pass over samples, aligned to a cache line.
static constexpr long ScratchSize(int degree, int rightDegree)
{
  long columns = 0;
  for (int first = 0; first <= rightDegree; first += OrdersPerFamily)
  {
    columns += rightDegree + 1 - first;
  }
  const long inChunk = 5 + 2L * (degree + 1) + 2L * (rightDegree + 1) +
                       (columns > degree + 1 ? columns : degree + 1L);
  return inChunk * ChunkPoints;
}

/// Functions of one instruction set. Sums are kept per lane (`laneSums`: 2 Lanes doubles per
/// moment) until the end of a pass.
struct Kernel
{
  int Lanes;
  /// Adds sum w (x+iy)^m p_k(z) for m + k <= degree to `gram`, and with w value instead of w and
  /// rightDegree to `right`.
  void (*Accumulate)(const Recurrence& recurrence, int degree, int rightDegree,
                     const Points& points, double* scratch, double* gram, double* right);
  /// Residuals, value - sum_mk (cosine p_k Re (x+iy)^m + sine p_k Im (x+iy)^m), and adds their
  /// moments, with the weights, to `right`. `coefficients` are pairs in the order of the moments.
  void (*Residuals)(const Recurrence& recurrence, int degree, const Points& points,
                    const double* coefficients, double* scratch, double* residuals, double* right);
  /// sum_k left[i][k] weights[c][k] right[k][j] for four sets of weights c: `left` has `rows` rows
  /// of `stride` doubles, `right` `nodes` rows of `columns` (a multiple of Lanes), `out` is
  /// [4][rows][columns].
  void (*WeightedProducts)(const double* left, int rows, int stride, const double* weights,
                           int nodes, const double* right, int columns, double* out);
};

/// `Set` describes an instruction set: `Vector`, a vector of doubles (GCC and Clang's vector
/// extension), and `Lanes`, how many it holds.
template <typename Set>
struct Arithmetic
{
  using Vector = typename Set::Vector;
  static constexpr int LaneCount = Set::Lanes;
  static constexpr int Vectors = ChunkPoints / LaneCount; // in a chunk
  static constexpr int Group = 4;                         // interleaved to hide latency

  // One chunk of samples as structure of arrays, and the rest of the scratch memory.
  struct Chunk
  {
    Vector* X;
    Vector* Y;
    Vector* Z2; // 2 z
    Vector* Weight;
    Vector* Value;
    Vector* Powers;   // real and imaginary part of (x+iy)^m, Vectors each
    Vector* Weighted; // the same times the factor of the right-hand side
    Vector* Columns;

    Chunk(double* scratch, int degree, int rightDegree)
    {
      Vector* at = reinterpret_cast<Vector*>(scratch);
      const auto take = [&at](int count)
      {
        Vector* block = at;
        at += count * Vectors;
        return block;
      };
      this->X = take(1);
      this->Y = take(1);
      this->Z2 = take(1);
      this->Weight = take(1);
      this->Value = take(1);
      this->Powers = take(2 * (degree + 1));
      this->Weighted = take(2 * (rightDegree + 1));
      this->Columns = at;
    }

    // Copies up to ChunkPoints samples starting at `first`, padded with samples of weight zero.
    void Load(const Points& points, long first)
    {
      auto* x = reinterpret_cast<double*>(this->X);
      auto* y = reinterpret_cast<double*>(this->Y);
      auto* z2 = reinterpret_cast<double*>(this->Z2);
      auto* weight = reinterpret_cast<double*>(this->Weight);
      auto* value = reinterpret_cast<double*>(this->Value);
      const long left = points.Count - first;
      for (int i = 0; i < ChunkPoints; ++i)
      {
        const bool exists = i < left;
        const double* direction = points.Directions + 3 * (exists ? first + i : first);
        x[i] = direction[0];
        y[i] = direction[1];
        z2[i] = 2.0 * direction[2];
        weight[i] = exists ? points.Weights[first + i] : 0.0;
        value[i] = exists ? points.Values[first + i] : 0.0;
      }
      this->Normalise();
    }

    // Unit vectors that were rounded, perhaps to float, are normalised. One step of Newton's method
    // for 1 / |u|, whose error is the square of the rounding error.
    void Normalise()
    {
      for (int v = 0; v < Vectors; ++v)
      {
        const Vector square =
            this->X[v] * this->X[v] + this->Y[v] * this->Y[v] + 0.25 * (this->Z2[v] * this->Z2[v]);
        const Vector scale = 1.5 - 0.5 * square;
        this->X[v] *= scale;
        this->Y[v] *= scale;
        this->Z2[v] *= scale;
      }
    }

    // seed (x+iy)^m for m = 0..degree.
    void RaisePowers(int degree, const Vector* seed)
    {
      for (int v = 0; v < Vectors; v += Group)
      {
        Vector real[Group];
        Vector imaginary[Group];
        for (int g = 0; g < Group; ++g)
        {
          real[g] = seed != nullptr ? seed[v + g] : Vector{} + 1.0;
          imaginary[g] = Vector{};
        }
        for (int m = 0; m <= degree; ++m)
        {
          for (int g = 0; g < Group; ++g)
          {
            const Vector x = this->X[v + g];
            const Vector y = this->Y[v + g];
            this->Powers[2 * m * Vectors + v + g] = real[g];
            this->Powers[(2 * m + 1) * Vectors + v + g] = imaginary[g];
            const Vector next = real[g] * x - imaginary[g] * y;
            imaginary[g] = imaginary[g] * x + real[g] * y;
            real[g] = next;
          }
        }
      }
    }

    // Multiplies the powers up to `degree` by `factor`.
    void WeightPowers(int degree, const Vector* factor)
    {
      for (int row = 0; row < 2 * (degree + 1); ++row)
      {
        for (int v = 0; v < Vectors; ++v)
        {
          this->Weighted[row * Vectors + v] = this->Powers[row * Vectors + v] * factor[v];
        }
      }
    }

    // p_0 .. p_last of one family.
    void FillColumns(const double* factors, int last, Vector* columns) const
    {
      for (int v = 0; v < Vectors; v += Group)
      {
        Vector previous[Group];
        Vector current[Group];
        for (int g = 0; g < Group; ++g)
        {
          previous[g] = Vector{};
          current[g] = Vector{} + 1.0;
          columns[v + g] = current[g];
        }
        for (int k = 1; k <= last; ++k)
        {
          const double factor = factors[k];
          for (int g = 0; g < Group; ++g)
          {
            const Vector next = this->Z2[v + g] * current[g] - factor * previous[g];
            previous[g] = current[g];
            current[g] = next;
            columns[k * Vectors + v + g] = next;
          }
        }
      }
    }
  };

  // Sums of `real` and `imaginary` times some columns over a chunk, added to `sums`.
  template <int Count>
  static inline __attribute__((always_inline)) void
  Tile(const Vector* real, const Vector* imaginary, const Vector* columns, Vector* sums)
  {
    Vector realSum[Count];
    Vector imaginarySum[Count];
    for (int j = 0; j < Count; ++j)
    {
      realSum[j] = Vector{};
      imaginarySum[j] = Vector{};
    }
    for (int v = 0; v < Vectors; ++v)
    {
      const Vector re = real[v];
      const Vector im = imaginary[v];
      for (int j = 0; j < Count; ++j)
      {
        realSum[j] += re * columns[j * Vectors + v];
        imaginarySum[j] += im * columns[j * Vectors + v];
      }
    }
    for (int j = 0; j < Count; ++j)
    {
      sums[2 * j] += realSum[j];
      sums[2 * j + 1] += imaginarySum[j];
    }
  }

  // The tiles of one order: as few as fit the registers, of about equal width.
  static void AddOrder(const Vector* powers, int count, const Vector* columns, Vector* sums)
  {
    constexpr int Widest = 6;
    const Vector* imaginary = powers + Vectors;
    for (int tiles = (count + Widest - 1) / Widest; tiles > 0; --tiles)
    {
      const int width = (count + tiles - 1) / tiles;
      switch (width)
      {
      case 6:
        Tile<6>(powers, imaginary, columns, sums);
        break;
      case 5:
        Tile<5>(powers, imaginary, columns, sums);
        break;
      case 4:
        Tile<4>(powers, imaginary, columns, sums);
        break;
      case 3:
        Tile<3>(powers, imaginary, columns, sums);
        break;
      case 2:
        Tile<2>(powers, imaginary, columns, sums);
        break;
      default:
        Tile<1>(powers, imaginary, columns, sums);
        break;
      }
      count -= width;
      columns += width * Vectors;
      sums += 2 * width;
    }
  }

  static void Accumulate(const Recurrence& recurrence, int degree, int rightDegree,
                         const Points& points, double* scratch, double* gram, double* right)
  {
    Chunk chunk(scratch, degree, rightDegree);
    auto* gramSums = reinterpret_cast<Vector*>(gram);
    auto* rightSums = reinterpret_cast<Vector*>(right);
    for (long first = 0; first < points.Count; first += ChunkPoints)
    {
      chunk.Load(points, first);
      chunk.RaisePowers(degree, chunk.Weight);
      chunk.WeightPowers(rightDegree, chunk.Value);
      for (int family = 0; family * OrdersPerFamily <= degree; ++family)
      {
        const int start = family * OrdersPerFamily;
        chunk.FillColumns(recurrence.Factors + family * recurrence.Stride, degree - start,
                          chunk.Columns);
        for (int m = start; m < start + OrdersPerFamily && m <= degree; ++m)
        {
          AddOrder(chunk.Powers + 2 * m * Vectors, degree + 1 - m, chunk.Columns,
                   gramSums + 2 * MomentStart(degree, m));
          if (m <= rightDegree)
          {
            AddOrder(chunk.Weighted + 2 * m * Vectors, rightDegree + 1 - m, chunk.Columns,
                     rightSums + 2 * MomentStart(rightDegree, m));
          }
        }
      }
    }
  }

  // Subtracts the contribution of one order of the model from the values.
  static void SubtractOrder(const Vector* powers, int count, const Vector* columns,
                            const double* coefficients, Vector* values)
  {
    for (int v = 0; v < Vectors; v += Group)
    {
      Vector cosine[Group];
      Vector sine[Group];
      for (int g = 0; g < Group; ++g)
      {
        cosine[g] = Vector{};
        sine[g] = Vector{};
      }
      for (int k = 0; k < count; ++k)
      {
        for (int g = 0; g < Group; ++g)
        {
          cosine[g] += coefficients[2 * k] * columns[k * Vectors + v + g];
          sine[g] += coefficients[2 * k + 1] * columns[k * Vectors + v + g];
        }
      }
      for (int g = 0; g < Group; ++g)
      {
        values[v + g] -= cosine[g] * powers[v + g] + sine[g] * powers[Vectors + v + g];
      }
    }
  }

  static void Residuals(const Recurrence& recurrence, int degree, const Points& points,
                        const double* coefficients, double* scratch, double* residuals,
                        double* right)
  {
    Chunk chunk(scratch, degree, degree);
    auto* sums = reinterpret_cast<Vector*>(right);
    for (long first = 0; first < points.Count; first += ChunkPoints)
    {
      chunk.Load(points, first);
      chunk.RaisePowers(degree, nullptr);
      Vector* columns = chunk.Columns;
      for (int start = 0; start <= degree; start += OrdersPerFamily)
      {
        const int family = start / OrdersPerFamily;
        chunk.FillColumns(recurrence.Factors + family * recurrence.Stride, degree - start, columns);
        for (int m = degree < start + OrdersPerFamily ? degree : start + OrdersPerFamily - 1;
             m >= start; --m)
        {
          SubtractOrder(chunk.Powers + 2 * m * Vectors, degree + 1 - m, columns,
                        coefficients + 2 * MomentStart(degree, m), chunk.Value);
        }
        columns += (degree + 1 - start) * Vectors;
      }
      Store(chunk.Value, points.Count - first, residuals + first);
      for (int v = 0; v < Vectors; ++v)
      {
        chunk.Value[v] *= chunk.Weight[v];
      }
      chunk.WeightPowers(degree, chunk.Value);
      columns = chunk.Columns;
      for (int m = 0; m <= degree; ++m)
      {
        columns +=
            m > 0 && m % OrdersPerFamily == 0 ? (degree + 1 - (m - OrdersPerFamily)) * Vectors : 0;
        AddOrder(chunk.Weighted + 2 * m * Vectors, degree + 1 - m, columns,
                 sums + 2 * MomentStart(degree, m));
      }
    }
  }

  static void Store(const Vector* values, long left, double* out)
  {
    const auto* from = reinterpret_cast<const double*>(values);
    for (int i = 0; i < ChunkPoints && i < left; ++i)
    {
      out[i] = from[i];
    }
  }

  template <int Rows>
  static inline __attribute__((always_inline)) void
  WeightedRows(const double* left, int stride, const double* weights, int nodes,
               const double* right, int columns, long set, double* out)
  {
    for (int j = 0; j < columns; j += LaneCount)
    {
      Vector sums[4][Rows];
      for (int c = 0; c < 4; ++c)
      {
        for (int i = 0; i < Rows; ++i)
        {
          sums[c][i] = Vector{};
        }
      }
      for (int k = 0; k < nodes; ++k)
      {
        Vector product[Rows];
        for (int i = 0; i < Rows; ++i)
        {
          product[i] = left[i * stride + k] *
                       *reinterpret_cast<const Vector*>(right + static_cast<long>(k) * columns + j);
        }
        for (int c = 0; c < 4; ++c)
        {
          const double weight = weights[c * stride + k];
          for (int i = 0; i < Rows; ++i)
          {
            sums[c][i] += weight * product[i];
          }
        }
      }
      for (int c = 0; c < 4; ++c)
      {
        for (int i = 0; i < Rows; ++i)
        {
          *reinterpret_cast<Vector*>(out + c * set + static_cast<long>(i) * columns + j) =
              sums[c][i];
        }
      }
    }
  }

  static void WeightedProducts(const double* left, int rows, int stride, const double* weights,
                               int nodes, const double* right, int columns, double* out)
  {
    const long set = static_cast<long>(rows) * columns;
    int i = 0;
    for (; i + 2 <= rows; i += 2)
    {
      WeightedRows<2>(left + static_cast<long>(i) * stride, stride, weights, nodes, right, columns,
                      set, out + static_cast<long>(i) * columns);
    }
    if (i < rows)
    {
      WeightedRows<1>(left + static_cast<long>(i) * stride, stride, weights, nodes, right, columns,
                      set, out + static_cast<long>(i) * columns);
    }
  }
};

/// Portable: two lanes are SSE2 on x86-64 and NEON on arm64.
extern const Kernel Portable;
/// For x86-64 with AVX2 and FMA.
extern const Kernel Avx2;
} // namespace palpate::moments
