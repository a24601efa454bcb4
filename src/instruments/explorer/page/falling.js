// Bodies that fall on the ground and on each other, and what of it can be heard.

const gravity = 9.81;        // m/s^2
const restingWay = 0.05;     // of the reach of a body: what does not go farther
const restingTime = 0.5;     // in so many seconds rests

class Falling {
  /// @param bodies  RigidBody; at most 2^20
  /// @param ground  its height, m; -Infinity: none
  /// @param bounce, friction  as of applyImpulses()
  constructor(bodies, ground, {bounce = 0.4, friction = 0.4, weight = gravity} = {}) {
    Object.assign(this, {bodies, ground, bounce, friction, weight, still: 0});
    this.before = bodies.map(({position, rows}) => ({position, rows}));
    this.skin = bodies.reduce((least, {reach}) => Math.min(least, 0.02 * reach), 2e-3);
  }

  get isAtRest() {
    return this.still >= restingTime;
  }

  /// Whether all bodies are where they were when one of them last was not.
  rests() {
    const stays = this.bodies.every(({position, rows, reach}, i) => {
      const {before: {[i]: before}} = this, most = restingWay * reach;
      return lengthOf(minus(position, before.position)) < most && rows.every((row, axis) => reach * lengthOf(minus(row, before.rows[axis])) < most);
    });
    if (!stays) this.before = this.bodies.map(({position, rows}) => ({position, rows}));
    return stays;
  }

  /// What happens in the next `duration` (s), as contacts that ContactSounds takes.
  step(duration) {
    for (const body of this.bodies) body.velocity = plus(body.velocity, [0, 0, -this.weight * duration]);
    const contacts = findContacts(this.bodies, this.ground, this.skin, duration);
    applyImpulses(contacts, this.bounce, this.friction);
    resistRolling(contacts, duration);
    for (const body of this.bodies) body.advance(duration);
    separate(contacts);
    this.still = this.rests() ? this.still + duration : 0;
    return contacts.filter(({impulse}) => impulse > 0).map(contact => this.eventOf(contact));
  }

  /// As include/idiophone/instruments/touching/contact_events.hpp has it. Points in one eighth of a body touch as one contact.
  eventOf({owner, other, point, place, normal, impulse, mass, moment, depth, slip}) {
    const number = body => body ? this.bodies.indexOf(body) : -1, eighth = point.reduce((key, part) => 2 * key + (part > 0 ? 1 : 0), 0);
    const carried = minus(owner.velocity, other?.velocity ?? [0, 0, 0]);
    return {contact: (number(owner) * (this.bodies.length + 1) + number(other) + 1) * 8 + eighth, bodies: [number(owner), number(other)],
            point: place, normal, impulse, slip, roll: lengthOf(alongSurface(carried, normal)), mass, moment: depth > 0 ? 0 : moment};
  }
}
