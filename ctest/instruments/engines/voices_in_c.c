/* voices_in_c FILE.voice FILE.proxy: a body with a sound map that is struck once and scraped, and a proxy that is
 * struck, by the C functions. Prints the sums of the squares of the sound with and without the proxy. */

#include <stdio.h>
#include <string.h>

#include "idiophone/voices.h"

enum { rate = 48000, frames = 800, steps = 30 };

static int fail(void) {
  printf("%s\n", idiophone_message());
  return 1;
}

static idiophone_contact contact_of(int body, int step) {
  idiophone_contact contact;
  memset(&contact, 0, sizeof contact);
  contact.phase = step == 0 ? IDIOPHONE_BEGIN : IDIOPHONE_PERSIST;
  contact.normal[2] = -1.0;
  contact.impulse = step == 0 ? 0.1 : 0.01;
  contact.slip[0] = body == 0 ? 0.5 : 0.0;
  contact.contact = (uint64_t)body;
  contact.bodies[0] = body;
  contact.bodies[1] = IDIOPHONE_NOBODY;
  contact.mass = 0.01;
  return contact;
}

int main(int count, char** arguments) {
  const double ears[3] = {0.1, 0.1, 1.0};
  const idiophone_surface steel = {2e11, 0.3, 0.01, 1e-6, 1.0, 5e-3, 2e-5, 0.3};
  idiophone_options options;
  idiophone_map* map = NULL;
  idiophone_proxy* proxy = NULL;
  idiophone_stage* stage = NULL;
  idiophone_report report;
  double power[2] = {0.0, 0.0};
  float sound[frames];
  int step, i;
  int32_t joined = -1, sprung = -1;

  memset(&options, 0, sizeof options);
  options.seed = 1;
  options.ears = ears;
  options.ear_count = 1;
  options.rate = rate;
  options.most_strokes = 4;
  if (idiophone_measured_speed(&options.speed) != IDIOPHONE_OK) return fail();
  if (count < 3 || idiophone_map_read(arguments[1], &map) != IDIOPHONE_OK) return fail();
  if (idiophone_proxy_read(arguments[1], &proxy) != IDIOPHONE_BAD_FILE || proxy != NULL) return 4;
  if (idiophone_proxy_read(arguments[2], &proxy) != IDIOPHONE_OK) return fail();
  options.ear_count = INT32_MAX; /* beyond the end of the list, which must not be read */
  if (idiophone_stage_create(&options, NULL, 0, &steel, 1, &stage) != IDIOPHONE_BAD_ARGUMENT || stage != NULL) return 7;
  options.ear_count = 1;
  if (idiophone_stage_create(&options, (const idiophone_map* const*)&map, 1, &steel, 1, &stage) != IDIOPHONE_OK)
    return fail();
  if (idiophone_stage_listen(stage, ears, INT32_MAX) != IDIOPHONE_BAD_ARGUMENT) return 8;
  if (idiophone_stage_add(stage, map, &joined) != IDIOPHONE_OK || joined != 1) return fail();
  if (idiophone_stage_add_proxy(stage, proxy, &sprung) != IDIOPHONE_OK || sprung != 2) return fail();
  if (idiophone_stage_tune(stage, sprung, 1.5, 1.0, 1.0) != IDIOPHONE_OK) return fail();
  if (idiophone_stage_tune(stage, joined, 1.5, 1.0, 1.0) == IDIOPHONE_OK) return 5;
  idiophone_map_free(map);
  idiophone_proxy_free(proxy);
  for (step = 0; step < 2 * steps; ++step) {
    const idiophone_contact contact = contact_of(0, step), tap = contact_of(sprung, 0);
    if (idiophone_stage_contact(stage, &contact) != IDIOPHONE_OK) return fail();
    if (step == steps && idiophone_stage_contact(stage, &tap) != IDIOPHONE_OK) return fail();
    if (idiophone_stage_step(stage, (double)frames / rate) != IDIOPHONE_OK) return fail();
    if (idiophone_stage_render(stage, sound, frames, 1.0) != IDIOPHONE_OK) return fail();
    for (i = 0; i < frames; ++i) power[step / steps] += (double)sound[i] * sound[i];
    if (step == steps && idiophone_stage_report(stage, &report) != IDIOPHONE_OK) return fail();
    if (step == steps && report.proxies != 1) return 6;
  }
  if (idiophone_stage_remove(stage, joined) != IDIOPHONE_OK) return fail();
  if (idiophone_stage_remove(stage, joined) != IDIOPHONE_BAD_ARGUMENT) return 3;
  if (idiophone_stage_report(stage, &report) != IDIOPHONE_OK) return fail();
  if (idiophone_stage_step(stage, -1.0) != IDIOPHONE_BAD_ARGUMENT) return 2;
  printf("%d impacts, %d strokes, %.6g, %.6g; %s\n", (int)report.impacts, (int)report.strokes, power[0], power[1],
         idiophone_message());
  idiophone_stage_free(stage);
  return 0;
}
