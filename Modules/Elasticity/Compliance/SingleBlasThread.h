#pragma once

namespace palpate
{
/// While one lives, OpenBLAS, where it is the BLAS in use, works on the calling thread only. With
/// several threads a result would depend on the number of processors, and threads that wait for
/// each other without sleeping would take minutes on a busy machine. Any number may live at a time.
class SingleBlasThread
{
public:
  SingleBlasThread();
  ~SingleBlasThread();
  SingleBlasThread(const SingleBlasThread&) = delete;
  SingleBlasThread& operator=(const SingleBlasThread&) = delete;
};
} // namespace palpate
