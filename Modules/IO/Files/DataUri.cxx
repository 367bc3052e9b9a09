#include "DataUri.h"

#include "vtkBase64Utilities.h"

namespace palpate
{
std::string DataUri(const std::string& mediaType, std::string_view bytes)
{
  std::string text((bytes.size() + 2) / 3 * 4, '=');
  vtkBase64Utilities::Encode(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(),
                             reinterpret_cast<unsigned char*>(text.data()));
  return "data:" + mediaType + ";base64," + text;
}
} // namespace palpate
