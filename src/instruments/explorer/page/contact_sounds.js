// The forces of contacts by the program's own C++, which src/instruments/page_sound/exports.cpp shows to this file.

/// As in include/idiophone/instruments/touching/contact_events.hpp.
const surfaceParts = ["young", "poisson", "radius", "height", "friction"];

class ContactSounds extends Compiled {
  /// @param surfaces     young (Pa), poisson, radius (m), height (m, of the roughness), friction of each
  /// @param rate         audio samples per second
  /// @param mostStrokes  contacts that scrape or roll at once
  /// @param mostImpacts  that begin in a step; the strongest are chosen
  constructor(code, surfaces, rate, {mostStrokes = 4, mostImpacts = 4, seed = 1} = {}) {
    super(code);
    this.give(...surfaces.map(surface => surfaceParts.map(part => surface[part])));
    this.contacts = code.make_contacts(surfaces.length, rate, mostStrokes, mostImpacts, seed);
  }

  /// What contacts do from an audio sample on: bodies (the force on the second one is the opposite), start, place, direction, force.
  /// @param events    Falling.eventOf(), and the numbers of both surfaces
  /// @param duration  of the step, s
  step(events, start, duration) {
    this.give(...events.map(({contact, bodies: pair, surfaces, point, normal, impulse, slip, roll, mass, moment}) =>
      [contact, ...pair, ...surfaces, ...point, ...normal, impulse, ...slip, roll, mass, moment]));
    const length = this.code.step_contacts(this.contacts, events.length, start, duration);
    const numbers = this.numbers(length).slice(), forces = [];
    for (let at = 0; at < length;) {
      const next = count => numbers.subarray(at, at += count), pair = [...next(2)], [begin] = next(1), place = [...next(3)], direction = [...next(3)];
      const [samples] = next(1), [mean, slope, first] = [0, 1, 2].map(() => next(samples).slice());
      forces.push({bodies: pair, start: begin, place, direction, force: {mean, slope, begin: first}});
    }
    return forces;
  }

  end() {
    this.code.end_contacts(this.contacts);
  }
}

/// The blows of a force on both bodies, as the audio thread takes them.
/// @param rigid  [bodies] RigidBody, where they are
function strikesOf({bodies: pair, start, place, direction, force}, rigid) {
  return pair.flatMap((index, side) => {
    if (index < 0) return [];
    const body = bodies[index], point = nearestOnSurface(body, rigid[index].toSurface(place));
    return [{body: index, level: body.level, start, force, ...sharesOf(body, point, rigid[index].inBody(scaled(direction, side ? -1 : 1)))}];
  });
}
