// The impulses that keep bodies from going into each other, one contact after the other until all agree (sequential impulses).

const rounds = 10;
const slowestBounce = 0.15;  // m/s: what touches more slowly stays

/// Gives the bodies the impulses of a step. Each contact gets its impulse along the normal (N s), the mass that this moves (kg), the
/// velocity of its owner's surface over the other's along the surfaces, `slip` (m/s), and its speed by rolling, `roll` (m/s).
/// @param contacts  findContacts()
/// @param bounce    speed after an impact over that before
/// @param friction  coefficient
function applyImpulses(contacts, bounce, friction) {
  for (const contact of contacts) {
    contact.arms = [minus(contact.place, contact.owner.position), contact.other && minus(contact.place, contact.other.position)];
    contact.mass = 1 / yielding(contact, contact.normal);
    contact.rubbedMass = 1 / Math.max(...acrossTo(contact.normal).map(direction => yielding(contact, direction)));
    const speed = dot(velocityOf(contact), contact.normal);
    Object.assign(contact, {impulse: 0, rubbed: [0, 0, 0], leaving: speed < -slowestBounce ? -bounce * speed : 0});
  }
  for (let round = 0; round < rounds; ++round) {
    for (const contact of contacts) {
      rub(contact, friction);
      repel(contact);
    }
  }
  for (const contact of contacts) Object.assign(contact, {slip: alongSurface(velocityOf(contact), contact.normal), roll: rollOf(contact)});
}

/// Of the owner over the other, m/s.
function velocityOf({owner, other, arms}) {
  const velocity = owner.velocityAt(arms[0]);
  return other ? minus(velocity, other.velocityAt(arms[1])) : velocity;
}

/// How fast the place where the owner touches goes along the other, m/s: as that of a ball, whose centre is as high, on a plane.
/// Turning about the normal is no rolling.
function rollOf({owner, other, arms, normal}) {
  const spin = minus(owner.spin, other?.spin ?? [0, 0, 0]);
  return lengthOf(alongSurface(spin, normal)) * Math.abs(dot(arms[0], normal));
}

/// Two directions at right angles to a unit vector and to each other.
function acrossTo(normal) {
  const first = unit(cross(normal, Math.abs(normal[0]) < 0.7 ? [1, 0, 0] : [0, 1, 0]));
  return [first, cross(normal, first)];
}

const alongSurface = (v, normal) => minus(v, scaled(normal, dot(v, normal)));

/// Velocity along a direction for an impulse of 1 N s along it, 1/kg.
function yielding({owner, other, arms}, direction) {
  return [owner, other].reduce((sum, body, side) => {
    if (!body) return sum;
    const lever = cross(arms[side], direction);
    return sum + 1 / body.mass + dot(lever, body.spinOf(lever));
  }, 0);
}

function push({owner, other, arms}, impulse) {
  owner.push(impulse, arms[0]);
  other?.push(scaled(impulse, -1), arms[1]);
}

function repel(contact) {
  const {normal, mass, leaving, impulse} = contact;
  contact.impulse = Math.max(0, impulse + mass * (leaving - dot(velocityOf(contact), normal)));
  push(contact, scaled(normal, contact.impulse - impulse));
}

/// Coulomb's friction: at most so many times the impulse along the normal.
function rub(contact, friction) {
  const {rubbed, rubbedMass, impulse, normal} = contact, most = friction * impulse;
  const wanted = minus(rubbed, scaled(alongSurface(velocityOf(contact), normal), rubbedMass)), size = lengthOf(wanted);
  contact.rubbed = size > most ? scaled(wanted, most / size) : wanted;
  push(contact, minus(contact.rubbed, rubbed));
}

/// Rolling costs energy: what touches turns alike after some time.
function resistRolling(contacts, duration) {
  const loss = 1;  // 1/s
  for (const {owner, other, impulse} of contacts) {
    if (!impulse) continue;
    const easy = [owner, other].reduce((sum, body) => sum + (body ? body.yields[0][0] + body.yields[1][1] + body.yields[2][2] : 0), 0);
    const twist = scaled(minus(owner.spin, other?.spin ?? [0, 0, 0]), -3 * loss * duration / easy);
    owner.spin = plus(owner.spin, owner.spinOf(twist));
    if (other) other.spin = minus(other.spin, other.spinOf(twist));
  }
}

/// Takes out a part of the depth by which bodies are inside each other, without a speed.
function separate(contacts) {
  const slop = 1e-3, share = 0.2;  // m
  for (const {owner, other, normal, depth} of contacts) {
    if (depth <= slop) continue;
    const way = share * (depth - slop), weight = other ? other.mass / (owner.mass + other.mass) : 1;
    owner.position = plus(owner.position, scaled(normal, weight * way));
    if (other) other.position = plus(other.position, scaled(normal, (weight - 1) * way));
  }
}
