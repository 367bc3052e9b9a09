#include "SampleData.h"

#include <QFileInfo>

#include <algorithm>

namespace palpate
{
bool SampleData::IsThere() const
{
  return std::all_of(this->Files.begin(), this->Files.end(),
                     [](const QString& file) { return QFileInfo::exists(file); });
}

const std::vector<SampleData>& SampleData::All()
{
  static const std::vector<SampleData> all{
      {"Head with 116 structures (Colin 27, AAL)",
       "mricron-data",
       {"/usr/share/mricron/templates/ch2.nii.gz", "/usr/share/mricron/templates/aal.nii.gz"}}};
  return all;
}
} // namespace palpate
