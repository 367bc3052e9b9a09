#include "SampleData.h"

#include "SampleScene.h"

#include <QFileInfo>

#include <algorithm>

namespace palpate
{
bool SampleData::IsThere() const
{
  return std::all_of(this->Files.begin(), this->Files.end(),
                     [](const QString& file) { return QFileInfo::exists(file); });
}

const SampleData& SampleData::Head()
{
  static const SampleData head = []
  {
    SampleData data{"mricron-data", {}};
    for (const std::filesystem::path& file : HeadFiles())
    {
      data.Files += QString::fromStdString(file.string());
    }
    return data;
  }();
  return head;
}
} // namespace palpate
