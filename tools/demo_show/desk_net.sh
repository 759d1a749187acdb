# SPDX-License-Identifier: Apache-2.0
# Sourced by scripts that need a lighting desk: two "machines" on one host as network namespaces that only reach each other,
#   $DESK 127.1.0.1 <- veth -> $VIS 127.1.0.2
# with multicast, broadcast and a UDP port 6454 of their own. Root only. desk_net_up fails where the kernel lacks a part.
DESK=ghost_desk_$$
VIS=ghost_vis_$$

desk_net_up() {
    [ "$(id -u)" = 0 ] && command -v ip >/dev/null || return 1
    for n in $DESK $VIS; do
        ip netns add $n 2>/dev/null || return 1
        ip -n $n link set lo up || return 1
    done
    ip link add gd$$ type veth peer name gv$$ 2>/dev/null || return 1
    ip link set gd$$ netns $DESK && ip link set gv$$ netns $VIS || return 1
    ip -n $DESK link set gd$$ name net0 && ip -n $VIS link set gv$$ name net0 || return 1
    for p in "$DESK 1" "$VIS 2"; do
        set -- $p
        # 127/8 on a wire: no address of the real world can be reached by mistake.
        ip netns exec $1 sysctl -qw net.ipv4.conf.all.route_localnet=1 net.ipv4.conf.net0.route_localnet=1 \
            net.ipv4.conf.all.rp_filter=0 net.ipv4.conf.net0.rp_filter=0 || return 1
        ip -n $1 addr add 127.1.0.$2/16 brd 127.1.255.255 dev net0 && ip -n $1 link set net0 up || return 1
        ip -n $1 route del local 127.0.0.0/8 dev lo table local
        ip -n $1 route add local 127.0.0.0/24 dev lo table local src 127.0.0.1
        ip -n $1 route replace 127.1.0.0/16 dev net0 src 127.1.0.$2 scope link || return 1
    done
}

desk_net_down() {
    for n in $DESK $VIS; do ip netns del $n 2>/dev/null; done
    ip link del gd$$ 2>/dev/null
    return 0
}
