/* A sphere of 20 mm: its volume, the push on a tool that is led into it, and a message. */
#include "palpate.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int near_to(double a, double b, double within)
{
  return fabs(a - b) <= within;
}

int main(void)
{
  const double pi = 3.14159265358979323846;
  const double center[3] = {1.0, 2.0, 3.0};
  const double coefficient = 20.0 * sqrt(4.0 * pi);
  const palpate_law law = {0.5, 0.0, 0.0, 0.0};
  const double outside[3] = {1.0, 2.0, 30.0};
  const double inside[3] = {1.0, 2.0, 22.0};
  palpate_error error;
  palpate_contact contact;
  double volume = 0.0;
  double area = 0.0;
  int is_right = 1;

  palpate_model* sphere = palpate_model_create(0, &coefficient, center, &error);
  palpate_scene* scene = palpate_scene_create();
  palpate_tracker* tracker = NULL;
  if (sphere == NULL || scene == NULL || !palpate_model_measure(sphere, &volume, &area, &error) ||
      !palpate_scene_add_model(scene, 7, sphere, &law, &error) ||
      (tracker = palpate_tracker_create(scene, &error)) == NULL)
  {
    fprintf(stderr, "%s\n", error.text);
    return 1;
  }
  is_right = is_right && near_to(volume, 4.0 / 3.0 * pi * 8000.0, 1e-6);
  is_right = is_right && palpate_tracker_follow(tracker, outside, &contact) && contact.id == 0;
  /* A tool of 1 mm stops 21 mm from the centre, 2 mm above the hand. */
  is_right = is_right && palpate_tracker_follow(tracker, inside, &contact) && contact.id == 7;
  is_right = is_right && near_to(contact.depth, 2.0, 1e-9) && near_to(contact.force[2], 1.0, 1e-9);
  is_right = is_right && palpate_model_read("absent.json", &error) == NULL;
  is_right = is_right && strstr(error.text, "absent.json") != NULL;
  printf("%.0f mm^3, %.3f N, \"%s\"\n", volume, contact.force[2], error.text);
  palpate_tracker_free(tracker);
  palpate_scene_free(scene);
  palpate_model_free(sphere);
  return is_right ? 0 : 1;
}
