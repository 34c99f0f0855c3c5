"""Reads the window from the accessibility bus (AT-SPI), as a screen reader does."""

import sys

import dbus

ACCESSIBLE, PROPERTIES = "org.a11y.atspi.Accessible", "org.freedesktop.DBus.Properties"
ROOT = "/org/a11y/atspi/accessible/root"
FOCUSABLE, FOCUSED, SHOWING = 11, 12, 25  # of AtspiStateType


def bus():
    session = dbus.SessionBus()
    address = session.get_object("org.a11y.Bus", "/org/a11y/bus").GetAddress(dbus_interface="org.a11y.Bus")
    return dbus.bus.BusConnection(address)


class Node:
    def __init__(self, connection, name, path):
        self.connection = connection
        self.object = connection.get_object(name, path, introspect=False)

    def call(self, method):
        return getattr(self.object, method)(dbus_interface=ACCESSIBLE)

    def name(self):
        return str(self.object.Get(ACCESSIBLE, "Name", dbus_interface=PROPERTIES))

    def role(self):
        return str(self.call("GetRoleName"))

    def has(self, state):
        low, high = self.call("GetState")
        return bool((int(low) | int(high) << 32) >> state & 1)

    def children(self):
        return [Node(self.connection, name, path) for name, path in self.call("GetChildren")]

    def below(self, path=""):
        """Everything, each with the way to it. Cells of tables are many and alike: the first stand for all."""
        for child in self.children()[:400]:
            child.path = f"{path} › {child.role()} “{child.name()}”"
            yield child
            yield from child.below(child.path)


def window():
    connection = bus()
    for application in Node(connection, "org.a11y.atspi.Registry", ROOT).children():
        if application.name().lower() == "alidade":
            return application
    sys.exit("the program is not on the bus")


def controls():
    nameless, roles = [], {}
    for node in window().below():
        role = node.role()
        roles[role] = roles.get(role, 0) + 1
        if node.has(FOCUSABLE) and node.has(SHOWING):
            if not node.name() or role in ("unknown", "invalid"):
                nameless.append(node.path)
    print(", ".join(f"{count} {role}" for role, count in sorted(roles.items())))
    for role in ("table", "cell", "text", "combo box", "push button", "page tab", "chart"):
        if role not in roles:
            nameless.append(f"no {role} at all")
    sys.exit("\n".join(nameless) or 0)


def points(chart, count):
    for node in window().below():
        if node.role() == "chart" and node.name() == chart:
            names = [child.name() for child in node.children() if child.role() == "list item"]
            told = [name for name in names if "point " in name]
            print(f"{chart}: {len(told)} points, such as “{told[0] if told else ''}”")
            sys.exit(0 if len(told) == len(names) == int(count) else f"not {count}: {len(names)}")
    sys.exit(f"no chart “{chart}”")


def focused(role, text):
    for node in window().below():
        if node.has(FOCUSED) and node.role() == role and text in node.name():
            print(f"the keyboard is on “{node.name()}”")
            return
    sys.exit("nothing of the kind has the keyboard")


if __name__ == "__main__":
    call, *arguments = sys.argv[1:]
    {"there": window, "controls": controls, "points": points, "focused": focused}[call](*arguments)
