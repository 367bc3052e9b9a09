#include "HexElasticity.h"

#include "HexahedronShape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace palpate
{
namespace
{
// The pattern of a matrix with 3 x 3 blocks, and the sums of the elements.
class BlockAssembly
{
public:
  explicit BlockAssembly(const StarMesh& mesh) : Neighbors(mesh.Nodes().size())
  {
    for (const StarMesh::Element& element : mesh.Elements())
    {
      for (const int column : element)
      {
        std::vector<int>& rows = this->Neighbors[static_cast<std::size_t>(column)];
        std::copy_if(element.begin(), element.end(), std::back_inserter(rows),
                     [column](int row) { return row >= column; });
      }
    }
    this->First.assign(this->Neighbors.size() + 1, 0);
    for (std::size_t column = 0; column < this->Neighbors.size(); ++column)
    {
      std::vector<int>& rows = this->Neighbors[column];
      std::sort(rows.begin(), rows.end());
      rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
      this->First[column + 1] = this->First[column] + rows.size();
    }
    this->Blocks.assign(this->First.back(), Matrix3::Zero());
  }

  // Ignored above the diagonal.
  void Add(int row, int column, const Matrix3& block)
  {
    if (row < column)
    {
      return;
    }
    const auto c = static_cast<std::size_t>(column);
    const std::vector<int>& rows = this->Neighbors[c];
    const auto place = std::lower_bound(rows.begin(), rows.end(), row) - rows.begin();
    this->Blocks[this->First[c] + static_cast<std::size_t>(place)] += block;
  }

  StiffnessMatrix Matrix() const
  {
    const auto size = static_cast<Eigen::Index>(3 * this->Neighbors.size());
    StiffnessMatrix matrix(size, size);
    matrix.reserve(static_cast<Eigen::Index>(9 * this->Blocks.size()));
    for (std::size_t column = 0; column < this->Neighbors.size(); ++column)
    {
      for (int c = 0; c < 3; ++c)
      {
        const auto at = static_cast<Eigen::Index>(3 * column) + c;
        matrix.startVec(at);
        for (std::size_t i = 0; i < this->Neighbors[column].size(); ++i)
        {
          const Matrix3& block = this->Blocks[this->First[column] + i];
          for (int r = 0; r < 3; ++r)
          {
            const Eigen::Index row = Eigen::Index{3} * this->Neighbors[column][i] + r;
            if (row >= at)
            {
              matrix.insertBack(row, at) = block(r, c);
            }
          }
        }
      }
    }
    matrix.finalize();
    return matrix;
  }

private:
  std::vector<std::vector<int>> Neighbors; // of each node, itself and later ones, ascending
  std::vector<std::size_t> First;          // block of each node
  std::vector<Matrix3> Blocks;
};

void AddElement(const StarMesh& mesh, const StarMesh::Element& element, const Vector3& centerWorld,
                const ElasticSolid& solid, BlockAssembly& assembly)
{
  const HexahedronShape shape(mesh.Nodes(), element);
  const double toShear = 0.5 / (1.0 + solid.PoissonRatio);
  const double toBulk = 1.0 / (3.0 * (1.0 - 2.0 * solid.PoissonRatio));
  std::array<double, 8> shear{};
  std::array<Vector3, 8> dilatation;
  dilatation.fill(Vector3::Zero());
  double yielding = 0.0; // volume over bulk modulus
  for (std::size_t g = 0; g < 8; ++g)
  {
    const HexahedronShape::Point& point = shape.Points()[g];
    const double modulus = solid.Tissue.Modulus(centerWorld + point.Position);
    shear[g] = toShear * modulus * point.Volume;
    yielding += point.Volume / (toBulk * modulus);
    for (std::size_t i = 0; i < 8; ++i)
    {
      dilatation[i] += point.Volume * point.Gradients[i];
    }
  }
  // One pressure in the element: the harmonic mean, over the volume.
  const double meanBulk = 1.0 / yielding;
  for (std::size_t i = 0; i < 8; ++i)
  {
    for (std::size_t j = 0; j < 8; ++j)
    {
      if (element[i] < element[j])
      {
        continue;
      }
      Matrix3 block = meanBulk * dilatation[i] * dilatation[j].transpose();
      for (std::size_t g = 0; g < 8; ++g)
      {
        const Vector3& a = shape.Points()[g].Gradients[i];
        const Vector3& b = shape.Points()[g].Gradients[j];
        block += shear[g] * (b * a.transpose() - (2.0 / 3.0) * a * b.transpose());
        block.diagonal().array() += shear[g] * a.dot(b);
      }
      assembly.Add(element[i], element[j], block);
    }
  }
}

void AddBed(const StarMesh& mesh, const StarMesh::Face& face, const ElasticBed& bed,
            BlockAssembly& assembly)
{
  const double gauss = 1.0 / std::sqrt(3.0);
  const auto node = [&](std::size_t i) -> const Vector3&
  { return mesh.Nodes()[static_cast<std::size_t>(face.Nodes[i])]; };
  for (const double s : {-gauss, gauss})
  {
    for (const double t : {-gauss, gauss})
    {
      const StarMesh::FacePoint point = StarMesh::At(face, s, t);
      const Vector3 alongS =
          0.25 * ((1.0 - t) * (node(1) - node(0)) + (1.0 + t) * (node(2) - node(3)));
      const Vector3 alongT =
          0.25 * ((1.0 - s) * (node(3) - node(0)) + (1.0 + s) * (node(2) - node(1)));
      const double stiffness = bed.At(point.Direction) * alongS.cross(alongT).norm();
      for (std::size_t i = 0; i < 4; ++i)
      {
        for (std::size_t j = 0; j < 4; ++j)
        {
          assembly.Add(face.Nodes[i], face.Nodes[j],
                       stiffness * point.Shape[i] * point.Shape[j] * Matrix3::Identity());
        }
      }
    }
  }
}
} // namespace

Status AssembleStiffness(const StarMesh& mesh, const Vector3& centerWorld,
                         const ElasticSolid& solid, StiffnessMatrix& stiffness)
{
  if (!(solid.PoissonRatio >= 0.0 && solid.PoissonRatio <= ElasticSolid::MostPoissonRatio))
  {
    return Status::Failure("Poisson's ratio is not a number from 0 to 0.4999.");
  }
  const Status tissue = solid.Tissue.Check();
  const Status bed = solid.Bed.Check();
  if (!tissue.IsOk() || !bed.IsOk())
  {
    return tissue.IsOk() ? bed : tissue;
  }
  BlockAssembly assembly(mesh);
  for (const StarMesh::Element& element : mesh.Elements())
  {
    AddElement(mesh, element, centerWorld, solid, assembly);
  }
  for (const StarMesh::Face& face : mesh.Faces())
  {
    AddBed(mesh, face, solid.Bed, assembly);
  }
  stiffness = assembly.Matrix();
  return Status::Success();
}
} // namespace palpate
