#include "OrganCodes.h"

#include <cctype>
#include <map>
#include <sstream>

namespace palpate
{
namespace
{
const std::map<std::string, CodedTerm>& Organs()
{
  static const std::map<std::string, CodedTerm> organs{
      {"adrenal gland", {"SCT", "23451007", "Adrenal gland"}},
      {"aorta", {"SCT", "15825003", "Aorta"}},
      {"brain", {"SCT", "12738006", "Brain"}},
      {"clavicula", {"SCT", "51299004", "Clavicle"}},
      {"colon", {"SCT", "71854001", "Colon"}},
      {"duodenum", {"SCT", "38848004", "Duodenum"}},
      {"esophagus", {"SCT", "32849002", "Esophagus"}},
      {"femur", {"SCT", "71341001", "Femur"}},
      {"gallbladder", {"SCT", "28231008", "Gallbladder"}},
      {"heart", {"SCT", "80891009", "Heart"}},
      {"humerus", {"SCT", "85050009", "Humerus"}},
      {"inferior vena cava", {"SCT", "64131007", "Inferior vena cava"}},
      {"kidney", {"SCT", "64033007", "Kidney"}},
      {"liver", {"SCT", "10200004", "Liver"}},
      {"lung", {"SCT", "39607008", "Lung"}},
      {"pancreas", {"SCT", "15776009", "Pancreas"}},
      {"prostate", {"SCT", "41216001", "Prostate"}},
      {"sacrum", {"SCT", "54735007", "Sacrum"}},
      {"scapula", {"SCT", "79601000", "Scapula"}},
      {"spinal cord", {"SCT", "2748008", "Spinal cord"}},
      {"spleen", {"SCT", "78961009", "Spleen"}},
      {"sternum", {"SCT", "56873002", "Sternum"}},
      {"stomach", {"SCT", "69695003", "Stomach"}},
      {"thyroid gland", {"SCT", "69748006", "Thyroid gland"}},
      {"trachea", {"SCT", "44567001", "Trachea"}},
      {"urinary bladder", {"SCT", "89837001", "Urinary bladder"}}};
  return organs;
}
} // namespace

SegmentCodes CodesOfName(const std::string& name)
{
  std::string plain;
  for (const unsigned char c : name)
  {
    plain += std::isalnum(c) != 0 ? static_cast<char>(std::tolower(c)) : ' ';
  }
  std::string organ;
  CodedTerm side;
  std::istringstream words(plain);
  for (std::string word; words >> word;)
  {
    side = word == "left"    ? CodedTerm{"SCT", "7771000", "Left"}
           : word == "right" ? CodedTerm{"SCT", "24028007", "Right"}
                             : side;
    if (word != "left" && word != "right")
    {
      organ += (organ.empty() ? "" : " ") + word;
    }
  }
  const auto found = Organs().find(organ);
  const CodedTerm tissue{"SCT", "85756007", "Tissue"};
  return found == Organs().end()
             ? SegmentCodes{tissue, tissue, {}, {}, {}}
             : SegmentCodes{
                   {"SCT", "123037004", "Anatomical Structure"}, found->second, side, {}, {}};
}
} // namespace palpate
