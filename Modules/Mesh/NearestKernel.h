#pragma once

// Nearest distances from several points at once. This header is compiled once for each instruction
// set, with different options, so it must not contain or include anything that another file could
// also instantiate.

namespace palpate::nearest
{
/// As TriangleTree::Node.
struct __attribute__((may_alias)) Node
{
  float Low[3];
  float High[3];
  int Second;
  int Count;
};

struct Mesh
{
  const Node* Nodes;
  const int* Triangles; ///< three points of each, in the order of the tree
  const double* Points; ///< x, y, z of each
};

/// As TriangleTree::MostPending.
constexpr int MostPending = 64;

/// Squared distances (mm^2) of points (x, y, z each), and the place of one of the nearest
/// triangles. Faster where points that follow each other are close.
struct Kernel
{
  void (*Find)(const Mesh& mesh, const double* points, long count, double* squares, int* places);
};

extern const Kernel Avx2;

/// `Set` describes an instruction set: `Vector`, a vector of `Lanes` doubles, `Integers` of as many
/// (GCC and Clang's vector extension), and Any(), whether a comparison holds in one lane.
template <typename Set>
struct Arithmetic
{
  using Vector = typename Set::Vector;
  using Integers = typename Set::Integers;
  static constexpr int Lanes = Set::Lanes;

  struct Points
  {
    Vector X;
    Vector Y;
    Vector Z;

    inline __attribute__((always_inline)) Vector Square() const
    {
      return this->X * this->X + this->Y * this->Y + this->Z * this->Z;
    }
  };

  struct Best
  {
    Vector Square;
    Integers Place;
  };

  struct Pending
  {
    Vector Square;
    int Node;
  };

  static inline __attribute__((always_inline)) Vector Least(const Vector& a, const Vector& b)
  {
    return a < b ? a : b;
  }
  static inline __attribute__((always_inline)) Vector Most(const Vector& a, const Vector& b)
  {
    return a > b ? a : b;
  }
  // To [0, 1]; what is not a number counts as 0.
  static inline __attribute__((always_inline)) Vector Share(const Vector& share)
  {
    const Vector zero{};
    return Least(Most(share, zero), zero + 1.0);
  }

  static inline __attribute__((always_inline)) Vector Outside(const Vector& at, float low,
                                                              float high)
  {
    const Vector zero{};
    const Vector below = static_cast<double>(low) - at;
    const Vector above = at - static_cast<double>(high);
    const Vector out = Most(Most(below, above), zero);
    return out * out;
  }
  static inline __attribute__((always_inline)) Vector SquareToBox(const Points& p, const Node& node)
  {
    return Outside(p.X, node.Low[0], node.High[0]) + Outside(p.Y, node.Low[1], node.High[1]) +
           Outside(p.Z, node.Low[2], node.High[2]);
  }

  // The least of four candidates: the nearest points of each edge, and that of the plane, moved
  // into the triangle. Each is a point of the triangle, and one of them the nearest.
  static inline __attribute__((always_inline)) Vector
  SquareToTriangle(const Points& p, const double* first, const double* second, const double* third)
  {
    const double b[3] = {second[0] - first[0], second[1] - first[1], second[2] - first[2]};
    const double c[3] = {third[0] - first[0], third[1] - first[1], third[2] - first[2]};
    const double bb = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];
    const double cc = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
    const double bc = b[0] * c[0] + b[1] * c[1] + b[2] * c[2];
    const Points a{p.X - first[0], p.Y - first[1], p.Z - first[2]};
    const Vector pb = a.X * b[0] + a.Y * b[1] + a.Z * b[2];
    const Vector pc = a.X * c[0] + a.Y * c[1] + a.Z * c[2];
    const auto squareAt = [&](const Vector& u, const Vector& v)
    {
      const Points from{a.X - u * b[0] - v * c[0], a.Y - u * b[1] - v * c[1],
                        a.Z - u * b[2] - v * c[2]};
      return from.Square();
    };
    const Vector zero{};
    const Vector edge = Share((pc - pb + (bb - bc)) * (1.0 / (bb + cc - 2.0 * bc)));
    const double scale = 1.0 / (bb * cc - bc * bc);
    const Vector u = Share((pb * cc - pc * bc) * scale);
    const Vector v = Least(Share((pc * bb - pb * bc) * scale), 1.0 - u);
    return Least(
        Least(squareAt(Share(pb * (1.0 / bb)), zero), squareAt(zero, Share(pc * (1.0 / cc)))),
        Least(squareAt(1.0 - edge, edge), squareAt(u, v)));
  }

  static inline __attribute__((always_inline)) void Consider(const Mesh& mesh, const Points& p,
                                                             int place, Best& best)
  {
    const int* t = mesh.Triangles + 3L * place;
    const Vector square = SquareToTriangle(p, mesh.Points + 3L * t[0], mesh.Points + 3L * t[1],
                                           mesh.Points + 3L * t[2]);
    const auto isLess = square < best.Square;
    best.Square = isLess ? square : best.Square;
    best.Place = isLess ? Integers{} + place : best.Place;
  }

  static inline __attribute__((always_inline)) double Sum(const Vector& of)
  {
    double sum = of[0];
    for (int lane = 1; lane < Lanes; ++lane)
    {
      sum += of[lane];
    }
    return sum;
  }

  // Visits what is nearer to any of the points than the best triangle so far.
  static inline __attribute__((always_inline)) void Search(const Mesh& mesh, const Points& p,
                                                           Best& best)
  {
    Pending pending[MostPending];
    int count = 0;
    int at = 0;
    for (;;)
    {
      const Node& node = mesh.Nodes[at];
      if (node.Count == 0)
      {
        Pending near{SquareToBox(p, mesh.Nodes[at + 1]), at + 1};
        Pending far{SquareToBox(p, mesh.Nodes[node.Second]), node.Second};
        if (Sum(near.Square - far.Square) > 0.0)
        {
          const Pending kept = near;
          near = far;
          far = kept;
        }
        if (Set::Any(far.Square < best.Square))
        {
          pending[count++] = far;
        }
        if (Set::Any(near.Square < best.Square))
        {
          at = near.Node;
          continue;
        }
      }
      for (int i = node.Second; i < node.Second + node.Count; ++i)
      {
        Consider(mesh, p, i, best);
      }
      while (count > 0 && !Set::Any(pending[count - 1].Square < best.Square))
      {
        --count;
      }
      if (count == 0)
      {
        return;
      }
      at = pending[--count].Node;
    }
  }

  static inline __attribute__((always_inline)) Vector Coordinate(const double* const* at, int axis)
  {
    if constexpr (Lanes == 4)
    {
      return Vector{at[0][axis], at[1][axis], at[2][axis], at[3][axis]};
    }
    else
    {
      return Vector{at[0][axis], at[1][axis]};
    }
  }

  static void Find(const Mesh& mesh, const double* points, long count, double* squares, int* places)
  {
    int start = 0;
    for (long first = 0; first < count; first += Lanes)
    {
      const double* at[Lanes];
      for (int lane = 0; lane < Lanes; ++lane)
      {
        at[lane] = points + 3L * (first + lane < count ? first + lane : count - 1);
      }
      const Points p{Coordinate(at, 0), Coordinate(at, 1), Coordinate(at, 2)};
      Best best{Vector{} + __builtin_inf(), Integers{}};
      Consider(mesh, p, start, best); // neighbours often follow each other
      Search(mesh, p, best);
      start = static_cast<int>(best.Place[Lanes - 1]);
      for (int lane = 0; lane < Lanes && first + lane < count; ++lane)
      {
        squares[first + lane] = best.Square[lane];
        places[first + lane] = static_cast<int>(best.Place[lane]);
      }
    }
  }
};
} // namespace palpate::nearest
