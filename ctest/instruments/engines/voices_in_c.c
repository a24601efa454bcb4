/* voices_in_c FILE.voice: a body that is struck once and scraped, by the C functions. Prints the sum of the sound's
 * squares. */

#include <stdio.h>
#include <string.h>

#include "idiophone/voices.h"

enum { rate = 48000, frames = 800, steps = 30 };

static int fail(void) {
  printf("%s\n", idiophone_message());
  return 1;
}

static idiophone_contact contact_at(int step) {
  idiophone_contact contact;
  memset(&contact, 0, sizeof contact);
  contact.phase = step == 0 ? IDIOPHONE_BEGIN : IDIOPHONE_PERSIST;
  contact.normal[2] = -1.0;
  contact.impulse = step == 0 ? 0.1 : 0.01;
  contact.slip[0] = 0.5;
  contact.bodies[1] = IDIOPHONE_NOBODY;
  contact.mass = 0.01;
  return contact;
}

int main(int count, char** arguments) {
  const double ears[3] = {0.1, 0.1, 1.0};
  const idiophone_surface steel = {2e11, 0.3, 0.01, 1e-6, 1.0, 5e-3, 2e-5, 0.3};
  idiophone_options options;
  idiophone_map* map = NULL;
  idiophone_stage* stage = NULL;
  idiophone_report report;
  double power = 0.0;
  float sound[frames];
  int step, i;
  int32_t joined = -1;

  memset(&options, 0, sizeof options);
  options.seed = 1;
  options.ears = ears;
  options.ear_count = 1;
  options.rate = rate;
  options.most_strokes = 4;
  if (idiophone_measured_speed(&options.speed) != IDIOPHONE_OK) return fail();
  if (count < 2 || idiophone_map_read(arguments[1], &map) != IDIOPHONE_OK) return fail();
  if (idiophone_stage_create(&options, (const idiophone_map* const*)&map, 1, &steel, 1, &stage) != IDIOPHONE_OK)
    return fail();
  if (idiophone_stage_add(stage, map, &joined) != IDIOPHONE_OK || joined != 1) return fail();
  idiophone_map_free(map);
  for (step = 0; step < steps; ++step) {
    const idiophone_contact contact = contact_at(step);
    if (idiophone_stage_contact(stage, &contact) != IDIOPHONE_OK) return fail();
    if (idiophone_stage_step(stage, (double)frames / rate) != IDIOPHONE_OK) return fail();
    if (idiophone_stage_render(stage, sound, frames, 1.0) != IDIOPHONE_OK) return fail();
    for (i = 0; i < frames; ++i) power += (double)sound[i] * sound[i];
  }
  if (idiophone_stage_remove(stage, joined) != IDIOPHONE_OK) return fail();
  if (idiophone_stage_remove(stage, joined) != IDIOPHONE_BAD_ARGUMENT) return 3;
  if (idiophone_stage_report(stage, &report) != IDIOPHONE_OK) return fail();
  if (idiophone_stage_step(stage, -1.0) != IDIOPHONE_BAD_ARGUMENT) return 2;
  printf("%d impacts, %d strokes, %.6g; %s\n", (int)report.impacts, (int)report.strokes, power, idiophone_message());
  idiophone_stage_free(stage);
  return 0;
}
