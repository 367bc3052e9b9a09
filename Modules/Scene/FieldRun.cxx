#include "FieldRun.h"

#include "Progress.h"

namespace palpate
{
Status RunBuilder(const FieldBuilder& builder, const char* stage, const ProgressFunction& progress,
                  std::shared_ptr<const ScalarField>& field)
{
  bool wasCancelled = false;
  const Status status = builder.Build(field,
                                      [&](double part)
                                      {
                                        wasCancelled = wasCancelled || !progress(part, stage);
                                        return !wasCancelled;
                                      });
  if (wasCancelled)
  {
    throw Cancelled();
  }
  return status;
}
} // namespace palpate
