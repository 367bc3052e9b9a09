#include <palpate.h>

int PalpateWorksInC(void);

int PalpateWorksInC(void)
{
  palpate_error error;
  return palpate_api_version() == PALPATE_API_VERSION &&
         palpate_model_read("absent.json", &error) == NULL;
}
