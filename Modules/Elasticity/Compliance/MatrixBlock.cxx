#include "MatrixBlock.h"

#include <algorithm>
#include <cstddef>

// By Fortran's names: the interface for C is also in other libraries, as in GSL's, which is slow.
// Last come the lengths of the letters.
extern "C"
{
  void dgemm_(const char* transA, const char* transB, const int* m, const int* n, const int* k,
              const double* alpha, const double* a, const int* lda, const double* b, const int* ldb,
              const double* beta, double* c, const int* ldc, std::size_t, std::size_t);
  void dsyrk_(const char* triangle, const char* trans, const int* n, const int* k,
              const double* alpha, const double* a, const int* lda, const double* beta, double* c,
              const int* ldc, std::size_t, std::size_t);
  void dtrsm_(const char* side, const char* triangle, const char* trans, const char* diagonal,
              const int* m, const int* n, const double* alpha, const double* a, const int* lda,
              double* b, const int* ldb, std::size_t, std::size_t, std::size_t, std::size_t);
}

namespace palpate
{
namespace
{
constexpr double One = 1.0;
constexpr double MinusOne = -1.0;
} // namespace

MatrixBlock::MatrixBlock(Eigen::MatrixXd& matrix, Eigen::Index row, Eigen::Index column,
                         Eigen::Index rows, Eigen::Index columns) noexcept
    : Data(matrix.data() + (row + column * matrix.rows())), Rows(static_cast<int>(rows)),
      Columns(static_cast<int>(columns)), Stride(std::max(1, static_cast<int>(matrix.rows())))
{
}

void MatrixBlock::SubtractProduct(const MatrixBlock& a, const MatrixBlock& b)
{
  dgemm_("N", "N", &this->Rows, &this->Columns, &a.Columns, &MinusOne, a.Data, &a.Stride, b.Data,
         &b.Stride, &One, this->Data, &this->Stride, 1, 1);
}

void MatrixBlock::SubtractOuterProduct(const MatrixBlock& a, const MatrixBlock& b)
{
  dgemm_("N", "T", &this->Rows, &this->Columns, &a.Columns, &MinusOne, a.Data, &a.Stride, b.Data,
         &b.Stride, &One, this->Data, &this->Stride, 1, 1);
}

void MatrixBlock::SubtractSquare(const MatrixBlock& a)
{
  dsyrk_("L", "N", &this->Rows, &a.Columns, &MinusOne, a.Data, &a.Stride, &One, this->Data,
         &this->Stride, 1, 1);
}

void MatrixBlock::AddProducts(const MatrixBlock& a)
{
  dsyrk_("L", "T", &a.Columns, &a.Rows, &One, a.Data, &a.Stride, &One, this->Data, &this->Stride, 1,
         1);
}

void MatrixBlock::Solve(const MatrixBlock& lower)
{
  dtrsm_("L", "L", "N", "N", &this->Rows, &this->Columns, &One, lower.Data, &lower.Stride,
         this->Data, &this->Stride, 1, 1, 1, 1);
}

void MatrixBlock::SolveFromRight(const MatrixBlock& lower)
{
  dtrsm_("R", "L", "T", "N", &this->Rows, &this->Columns, &One, lower.Data, &lower.Stride,
         this->Data, &this->Stride, 1, 1, 1, 1);
}
} // namespace palpate
