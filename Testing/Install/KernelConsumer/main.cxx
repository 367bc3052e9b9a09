#include <palpate/ModelMeasures.h>
#include <palpate/OrganContact.h>
#include <palpate/RadialModel.h>

#include <cmath>
#include <memory>

extern "C" int PalpateWorksInC(void);

// A sphere of 10 mm.
int main()
{
  using namespace palpate;
  const auto sphere = std::make_shared<const RadialModel>(
      0, std::vector<double>{10.0 * std::sqrt(4.0 * 3.14159265358979323846)}, Vector3::Zero());
  std::shared_ptr<const ContactModel> contact;
  const bool isTouched = MakeOrganContact(sphere, RadialContactMode::Nearest, contact).IsOk();
  const bool isRight = std::abs(VolumeOf(*sphere) - 4188.79) < 0.01;
  return isTouched && isRight && PalpateWorksInC() != 0 ? 0 : 1;
}
