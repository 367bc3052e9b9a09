#pragma once

#include "PalpateReportModule.h"
#include "Progress.h"

#include <stdexcept>
#include <string>

class vtkAlgorithm;

namespace palpate
{
/// A filter raised an error; what() is its message.
class FilterError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Updates a filter, reports its progress as the part [from, to] of a stage, aborts it when
/// `progress` returns false, and throws FilterError or Cancelled instead of printing to the error
/// stream.
PALPATEREPORT_EXPORT void RunFilter(vtkAlgorithm* filter, const std::string& stage, double from,
                                    double to, const ProgressFunction& progress);
} // namespace palpate
