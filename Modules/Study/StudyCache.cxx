#include "StudyCache.h"

#include <utility>

namespace palpate
{
const SceneProduct* StudyCache::Find(const std::string& key)
{
  const auto place = this->Places.find(key);
  if (place == this->Places.end())
  {
    return nullptr;
  }
  this->Items.splice(this->Items.begin(), this->Items, place->second);
  return &place->second->Product;
}

void StudyCache::Store(const std::string& key, SceneProduct product)
{
  this->Forget(key);
  const std::size_t bytes = BytesOf(product);
  this->Items.push_front({key, std::move(product), bytes});
  this->Places[key] = this->Items.begin();
  this->HeldBytes += bytes;
  // The newest stays, however large it is.
  while (this->HeldBytes > this->MostBytes && this->Items.size() > 1)
  {
    this->Forget(std::string(this->Items.back().Key));
  }
}

void StudyCache::Forget(const std::string& key)
{
  const auto place = this->Places.find(key);
  if (place != this->Places.end())
  {
    this->HeldBytes -= place->second->Bytes;
    this->Items.erase(place->second);
    this->Places.erase(place);
  }
}
} // namespace palpate
